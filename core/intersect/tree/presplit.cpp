#include "core/intersect/tree/presplit.h"

#include "core/intersect/tree/prospect.h"
#include "core/parallel/chunks.h"

namespace etalon {
namespace {

using Primitives = std::span<const BoundedPrimitive>;

constexpr std::size_t chunk_size = 4096;
constexpr std::size_t sample_size = 4096;
constexpr double no_limit = 0x1p40;

/// Of every so many-th primitive.
std::vector<Prospect> sample(const Scene& scene, const Frame& frame, Primitives primitives) {
    const std::size_t step = primitives.size() / sample_size + 1;
    std::vector<Prospect> result;
    for (std::size_t i = 0; i < primitives.size(); i += step) {
        result.emplace_back(scene, frame, primitives[i]);
    }
    return result;
}

std::vector<Prospect> all_prospects(const Scene& scene, const Frame& frame, Primitives primitives) {
    std::vector<Prospect> result(primitives.size());
    const Chunks chunks(primitives.size(), chunk_size);
    chunks.parallel_for_each([&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = {scene, frame, primitives[i]};
    });
    return result;
}

void add_references(const Scene& scene, const Frame& frame, const BoundedPrimitive& p, int cuts,
                    std::vector<BoundedPrimitive>& references) {
    if (cuts == 0) {
        references.push_back(p);
        return;
    }
    const Corners corners = corners_of(scene, p);
    std::vector<Box3> pieces;
    add_pieces(corners, box_of(corners), cuts, frame, pieces);
    for (const Box3& piece : pieces) {
        references.emplace_back(frame.box(piece), p.id, static_cast<ShapeKind>(p.kind));
    }
}

}  // namespace

/// The sample's factor does for all, unless it missed some that ask for many cuts.
std::optional<std::vector<BoundedPrimitive>> presplit(const Scene& scene, const Frame& frame,
                                                      Primitives primitives,
                                                      const PresplitConfig& config) {
    const auto budget = [&](const std::vector<Prospect>& prospects) {
        return config.budget * static_cast<double>(prospects.size());
    };
    const std::vector<Prospect> some = sample(scene, frame, primitives);
    const double limit = best_factor(some, budget(some), no_limit);
    if (!(gain(some, limit) >= config.least_gain)) return std::nullopt;

    const std::vector<Prospect> all = all_prospects(scene, frame, primitives);
    const double factor = best_factor(all, budget(all), limit);
    const Chunks chunks(primitives.size(), chunk_size);
    std::vector<std::vector<BoundedPrimitive>> of_chunk(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            add_references(scene, frame, primitives[i], all[i].cuts(factor), of_chunk[chunk]);
        }
    });
    std::vector<BoundedPrimitive> references;
    for (const auto& c : of_chunk) references.insert(references.end(), c.begin(), c.end());
    return references;
}

}  // namespace etalon
