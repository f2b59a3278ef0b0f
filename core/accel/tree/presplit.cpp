#include "core/accel/tree/presplit.h"

#include <algorithm>

#include "core/accel/tree/split_candidate.h"
#include "core/accel/tree/triangle_pieces.h"
#include "core/parallel/chunks.h"

namespace etalon {
namespace {

using Primitives = std::span<const BoundedPrimitive>;
using References = std::vector<BoundedPrimitive>;

constexpr std::size_t chunk_size = 4096;
constexpr std::size_t sample_size = 4096;
constexpr double no_limit = 0x1p40;

/// Returns candidates for every n-th primitive, at most sample_size of them.
std::vector<SplitCandidate> sample(const Geometry& geometry, const NormalizedSpace& space,
                                   Primitives primitives) {
    const std::size_t step = primitives.size() / sample_size + 1;
    std::vector<SplitCandidate> result;
    for (std::size_t i = 0; i < primitives.size(); i += step) {
        result.emplace_back(geometry, space, primitives[i]);
    }
    return result;
}

/// Some primitives, with their indices among all.
struct Candidates {
    void add(const Candidates& other) {
        places.insert(places.end(), other.places.begin(), other.places.end());
        candidates.insert(candidates.end(), other.candidates.begin(), other.candidates.end());
    }

    std::vector<std::size_t> places;
    std::vector<SplitCandidate> candidates;
};

/// Finds all primitives that a factor up to `limit` might cut.
Candidates find_candidates(const Geometry& geometry, const NormalizedSpace& space,
                           Primitives primitives, double limit) {
    const Chunks chunks(primitives.size(), chunk_size);
    std::vector<Candidates> of_chunk(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!might_be_cut(primitives[i], limit)) continue;
            of_chunk[chunk].places.push_back(i);
            of_chunk[chunk].candidates.emplace_back(geometry, space, primitives[i]);
        }
    });
    Candidates all;
    for (const Candidates& c : of_chunk) all.add(c);
    return all;
}

References copy(Primitives primitives, std::size_t room) {
    References result;
    result.reserve(room);
    result.resize(primitives.size());
    const Chunks chunks(primitives.size(), chunk_size);
    chunks.parallel_for_each([&](std::size_t, std::size_t begin, std::size_t end) {
        std::copy(primitives.begin() + begin, primitives.begin() + end, result.begin() + begin);
    });
    return result;
}

/// Pads the box of a piece, with room for piece_error, clipped to the box of the whole primitive.
BoundedPrimitive padded(const Bounds& piece, const BoundedPrimitive& whole) {
    const auto pad = Bounds::corner(static_cast<float>(NormalizedSpace::padding) + piece_error);
    const Bounds within = Bounds::of(whole);
    Bounds box;
    box.min = Bounds::upper(piece.min - pad, within.min);
    box.max = Bounds::lower(piece.max + pad, within.max);
    return {box.box(), whole.id, static_cast<ShapeKind>(whole.kind)};
}

/// Replaces primitives by their pieces.
class Cutter {
  public:
    Cutter(const Geometry& geometry, const NormalizedSpace& space)
        : geometry_(geometry), space_(space) {}

    void cut(BoundedPrimitive& p, int cuts) {
        const Corners corners = corners_in(space_, corners_of(geometry_, p));
        boxes_.clear();
        add_pieces(corners, bounds_of(corners), cuts, boxes_);
        whole.push_back(p);
        for (const Bounds& box : boxes_) others.push_back(padded(box, p));
        p = others.back();
        others.pop_back();
    }

    References whole, others;

  private:
    const Geometry& geometry_;
    const NormalizedSpace& space_;
    std::vector<Bounds> boxes_;
};

}  // namespace

/// Uses the sample's factor for all, unless the sample missed some with many cuts.
std::optional<Presplit> presplit(const Geometry& geometry, const NormalizedSpace& space,
                                 Primitives primitives, const PresplitConfig& config) {
    const auto budget = [&](std::size_t number) {
        return config.budget * static_cast<double>(number);
    };
    const std::vector<SplitCandidate> some = sample(geometry, space, primitives);
    const double limit = best_factor(some, budget(some.size()), no_limit);
    if (!(gain(some, limit) >= config.least_gain)) return std::nullopt;

    const Candidates all = find_candidates(geometry, space, primitives, limit);
    const double most = budget(primitives.size());
    const double factor = best_factor(all.candidates, most, limit);
    Presplit result{copy(primitives, primitives.size() + static_cast<std::size_t>(most)), {}};
    const Chunks chunks(all.places.size(), chunk_size / 16);
    std::vector<Cutter> of_chunk(chunks.number(), Cutter(geometry, space));
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int cuts = all.candidates[i].cuts(factor);
            if (cuts > 0) of_chunk[chunk].cut(result.references[all.places[i]], cuts);
        }
    });
    for (const Cutter& c : of_chunk) {
        result.cut.insert(result.cut.end(), c.whole.begin(), c.whole.end());
        result.references.insert(result.references.end(), c.others.begin(), c.others.end());
    }
    return result;
}

}  // namespace etalon
