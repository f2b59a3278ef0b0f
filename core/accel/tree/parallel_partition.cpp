#include "core/accel/tree/parallel_partition.h"

#include "core/parallel/chunks.h"

namespace etalon {
namespace {

using Primitives = std::span<BoundedPrimitive>;

constexpr std::size_t chunk_size = 8192;

SplitSets halve(Primitives primitives) {
    const std::size_t middle = smaller_half(primitives);
    return {summarize_bounds(primitives.first(middle)).set,
            summarize_bounds(primitives.subspan(middle)).set};
}

/// Bins of each chunk, and their sum.
struct ChunkedBins {
    ChunkedBins(Primitives primitives, const Binning& binning, const LeafWeights& weights)
        : chunks(primitives.size(), chunk_size), of_chunk(chunks.number()) {
        chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
            of_chunk[chunk].count(binning, primitives.subspan(begin, end - begin), weights);
        });
        all = of_chunk.front();
        for (std::size_t i = 1; i < of_chunk.size(); ++i) all.add(of_chunk[i]);
    }

    /// Returns, for each chunk, how many primitives of all earlier chunks go left.
    std::vector<std::size_t> left_before(const Split& split) const {
        std::vector<std::size_t> result{0};
        for (const Bins& bins : of_chunk) {
            result.push_back(result.back() + bins.sum(split.axis, 0, split.bin).count);
        }
        return result;
    }

    Chunks chunks;
    std::vector<Bins> of_chunk;
    Bins all;
};

SplitSets scatter_chunks(Primitives primitives, Primitives target, const Binning& binning,
                         const ChunkedBins& bins, const Split& split) {
    const std::vector<std::size_t> left_before = bins.left_before(split);
    const auto [left, right] = sides(bins.all, split);
    BoundedPrimitive* const middle = target.data() + left.count;
    std::vector<SideCentres> of_chunk(bins.chunks.number());
    bins.chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        const std::size_t before = left_before[chunk];
        of_chunk[chunk] = scatter(primitives.subspan(begin, end - begin), binning, split,
                                  target.data() + before, middle + (begin - before));
    });
    SideCentres centres;
    for (const SideCentres& c : of_chunk) centres.extend(c);
    return {{target.first(left.count), left.bounds, centres.left},
            {target.subspan(left.count), right.bounds, centres.right}};
}

}  // namespace

void BoundsSummary::add(const BoundsSummary& other) {
    set.extend(other.set);
    for (std::size_t kind = 0; kind < item_kinds; ++kind) of_kind[kind] += other.of_kind[kind];
}

BoundsSummary summarize_bounds(Primitives primitives) {
    const Chunks chunks(primitives.size(), chunk_size);
    std::vector<BoundsSummary> of_chunk(chunks.number());
    chunks.parallel_for_each([&](std::size_t chunk, std::size_t begin, std::size_t end) {
        BoundsSummary result{with_bounds(primitives.subspan(begin, end - begin))};
        for (const BoundedPrimitive& p : result.set.primitives) ++result.of_kind[p.kind];
        of_chunk[chunk] = result;
    });
    BoundsSummary all{{primitives, {}, {}}};
    for (const BoundsSummary& s : of_chunk) all.add(s);
    return all;
}

SplitResult split_large(const PrimitiveSet& set, Primitives spare, bool in_halves,
                        const BvhConfig& config, const LeafWeights& weights) {
    if (in_halves) return {halve(set.primitives), spare};
    const Binning binning(set.centres, config.bins);
    const ChunkedBins bins(set.primitives, binning, weights);
    const Split split = cheapest_split(bins.all, weights);
    if (split.axis < 0) return {halve(set.primitives), spare};
    return {scatter_chunks(set.primitives, spare, binning, bins, split), set.primitives};
}

}  // namespace etalon
