// Properties of the binary tree under the BVH, for any input and number of threads.
#include "core/accel/tree/builder.h"

#include <algorithm>

#include "core/accel/tree/binning.h"
#include "core/accel/tree/split.h"
#include "core/parallel/parallel.h"
#include "tests/backends/trees.h"
#include "tests/catch.h"

using namespace etalon;

TEST_CASE("Given any primitives, each is in one leaf, of its kind, in boxes that nest") {
    for (const std::size_t count : {0U, 1U, 2U, 8U, 9U, 100U, 4095U, 4097U, 20000U}) {
        for (const Cast cast : all_casts()) {
            CAPTURE(count, reinterpret_cast<const void*>(cast));
            const Primitives primitives = cast(count);
            require_sound(build_bvh(primitives), primitives);
        }
    }
}

TEST_CASE("Given any limits, a tree keeps them") {
    const Primitives primitives = of_all_kinds(3000);
    for (const std::uint32_t max_leaf : {1U, 2U, 5U, 8U, 16U}) {
        for (const std::size_t serial_below : {0U, 1U, 10U, 100000U}) {
            for (const int bins : {2, 16, max_bins}) {
                BvhConfig config;
                config.max_leaf = max_leaf;
                config.serial_below = serial_below;
                config.bins = bins;
                CAPTURE(max_leaf, serial_below, bins);
                require_sound(build_bvh(primitives, config), primitives, config);
            }
        }
    }
}

TEST_CASE("Given another number of threads, the tree is the same", "[needs_two_cores]") {
    SKIP_UNLESS(max_threads() >= 2, "a single core");
    for (const Cast cast : all_casts()) {
        const Primitives primitives = cast(50'000);
        const auto built = [&](int threads) {
            const ThreadLimit limit(threads);
            return build_bvh(primitives);
        };
        CAPTURE(reinterpret_cast<const void*>(cast));
        const BvhTree alone = built(1);
        CHECK(same(alone, built(2)));
        CHECK(same(alone, built(7)));
    }
}

TEST_CASE("Given many triangles, most lanes of the leaves are taken") {
    const Primitives primitives = scattered(100'000);
    const Inspection found(build_bvh(primitives), primitives);
    CHECK(100 * primitives.size() > 85 * 8 * found.leaves);
}

TEST_CASE("Given primitives of a kind that is tested one by one, small leaves are divided") {
    Primitives primitives = scattered(8);
    CHECK(Inspection(build_bvh(primitives), primitives).leaves == 1);
    for (BoundedPrimitive& p : primitives) p.kind = kind_of<Box>();
    CHECK(Inspection(build_bvh(primitives), primitives).leaves == 8);
}

TEST_CASE("Given boxes about one centre, the small ones are kept from the large ones") {
    const Primitives primitives = concentric(1000);
    const BvhTree tree = build_bvh(primitives);
    float smallest = tree.nodes[0].box.size().x;
    for (const BvhNode& node : tree.nodes) {
        if (node.is_leaf() && &node != &tree.nodes[1])
            smallest = std::min(smallest, node.box.size().x);
    }
    CHECK(smallest < 1e-4F * tree.nodes[0].box.size().x);
}

TEST_CASE("Given few primitives, sorting them finds the split that counting their bins does") {
    const LeafWeights weights(default_leaf_costs(), kind_of<Triangle>());
    for (const Cast cast : {scattered, of_all_kinds, in_pairs}) {
        for (std::size_t seed = 0; seed < 200; ++seed) {
            Primitives all = cast(100 + seed);
            const std::span few = std::span(all).last(2 + seed % (few_primitives - 1));
            Bounds centres;
            for (const BoundedPrimitive& p : few) centres.extend(twice_centre(Bounds::of(p)));
            const Binning binning(centres, 16 + static_cast<int>(few.size() / 4));
            Bins bins;
            bins.count(binning, few, weights);
            const Split counted = cheapest_split(bins, weights);
            const Split sorted = cheapest_split(few, binning, weights);
            CAPTURE(seed);
            REQUIRE(sorted.axis == counted.axis);
            REQUIRE(sorted.bin == counted.bin);
            REQUIRE(sorted.cost == counted.cost);
            if (sorted.axis < 0) continue;
            const SplitSides from_bins = sides(bins, counted),
                             from_boxes = sides(few, binning, weights, sorted);
            REQUIRE(from_boxes.left.count == from_bins.left.count);
            REQUIRE(from_boxes.right.weight == from_bins.right.weight);
            REQUIRE(from_boxes.left.bounds.box() == from_bins.left.bounds.box());
            REQUIRE(from_boxes.right.bounds.box() == from_bins.right.bounds.box());
        }
    }
}
