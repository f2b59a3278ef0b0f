// Properties of the binary tree under the BVH, for any input and number of threads.
#include "core/accel/tree/builder.h"

#include <algorithm>

#include "core/accel/tree/binning.h"
#include "core/accel/tree/split.h"
#include "core/numerics/random.h"
#include "core/parallel/parallel.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr ShapeKind sphere = kind_of<Sphere>(), triangle = kind_of<Triangle>(),
                    box_kind = kind_of<Box>();

using Primitives = std::vector<BoundedPrimitive>;
using Cast = Primitives (*)(std::size_t count);

BoundedPrimitive primitive(const Vec3& centre, const Vec3& half, std::size_t id, ShapeKind kind) {
    const Box3f box(Vec3f(centre - half), Vec3f(centre + half));
    return {box, static_cast<std::uint32_t>(id), kind};
}

/// Returns the primitives make(random, id).
template <class Make>
Primitives generate(std::size_t count, const Make& make) {
    Random random(count);
    Primitives list;
    for (std::size_t id = 0; id < count; ++id) list.push_back(make(random, id));
    return list;
}

Vec3 small_box(Random& random) {
    return Vec3(random.uniform(0, 0.01), random.uniform(0, 0.01), random.uniform(0, 0.01));
}

Primitives scattered(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const Vec3 centre = random.in_cube();
        return primitive(centre, small_box(random), id, triangle);
    });
}

Primitives of_all_kinds(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const Vec3 centre = random.in_cube();
        const auto kind = static_cast<ShapeKind>(random.index(shape_kinds));
        return primitive(centre, small_box(random), id, kind);
    });
}

/// Two shapes at the same positions.
Primitives in_pairs(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const Vec3 place = random.in_cube();
        return primitive(Vec3(place.x > 0 ? 0.5 : -0.5), Vec3(0.1), id, id % 2 ? sphere : box_kind);
    });
}

Primitives identical(std::size_t count) {
    return generate(count, [](Random&, std::size_t id) {
        return primitive(Vec3(0.25), Vec3(0.5), id, triangle);
    });
}

Primitives concentric(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const double half = random.magnitude(-6, 0);
        return primitive(Vec3(0), Vec3(half), id, sphere);
    });
}

Primitives in_a_plane(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const Vec3 place = random.in_cube();
        return primitive(Vec3(place.x, 0.5, place.z), Vec3(0.01, 0, 0.01), id, triangle);
    });
}

/// Each half as far from the corner as the previous one, so that bins separate only a few.
Primitives ever_closer(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const double distance = random.magnitude(-30, 0);
        return primitive(Vec3(distance), Vec3(distance / 100), id, triangle);
    });
}

/// So close together that the reciprocal of a bin's width is not a float.
Primitives denormal(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        return primitive(1e-41 * random.in_cube(), Vec3(1e-42), id, triangle);
    });
}

constexpr Cast casts[] = {scattered,  of_all_kinds, in_pairs,    identical,
                          concentric, in_a_plane,   ever_closer, denormal};

bool contains(const Box3f& outer, const Box3f& inner) {
    return outer.intersects(inner.min) && outer.intersects(inner.max);
}

/// Counts of a traversal of the whole tree.
class Inspection {
  public:
    Inspection(const BvhTree& tree, const Primitives& primitives, const BvhConfig& config)
        : tree_(tree), primitives_(primitives), config_(config), seen(primitives.size()) {
        if (!tree.nodes.empty()) visit(tree.nodes[0], 0);
    }

    bool each_once() const {
        return std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; });
    }

  private:
    void visit(const BvhNode& node, int level) {
        ++nodes;
        depth = std::max(depth, level);
        if (node.is_leaf()) return visit_leaf(node);
        for (std::uint32_t i : {node.first, node.first + 1}) {
            if (!contains(node.box, tree_.nodes[i].box)) ++outside_parent;
            visit(tree_.nodes[i], level + 1);
        }
    }

    void visit_leaf(const BvhNode& node) {
        ++leaves;
        if (node.count > config_.max_leaf) ++too_large;
        const std::uint32_t kind = primitives_[tree_.ids[node.first]].kind;
        Box3f together;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const BoundedPrimitive& p = primitives_[tree_.ids[i]];
            ++seen[p.id];
            if (p.kind != kind) ++of_other_kind;
            together.extendBy(p.box());
        }
        if (together != node.box) ++loose_leaves;
    }

    const BvhTree& tree_;
    const Primitives& primitives_;
    const BvhConfig& config_;

  public:
    std::vector<int> seen;  ///< occurrences of each primitive
    std::size_t nodes = 0, leaves = 0;
    std::size_t outside_parent = 0, too_large = 0, of_other_kind = 0, loose_leaves = 0;
    int depth = 0;
};

void require_sound(const Primitives& primitives, const BvhConfig& config) {
    const BvhTree tree = build_bvh(primitives, config);
    const Inspection found(tree, primitives, config);
    CHECK(tree.ids.size() == primitives.size());
    CHECK(found.each_once());
    CHECK(found.nodes == 2 * found.leaves - (primitives.empty() ? 0 : 1));
    CHECK(tree.nodes.size() == (primitives.empty() ? 0 : found.nodes + 1));
    CHECK(found.outside_parent == 0);
    CHECK(found.too_large == 0);
    CHECK(found.of_other_kind == 0);
    CHECK(found.loose_leaves == 0);
    CHECK(found.depth <= bvh_max_depth);
}

bool same(const BvhNode& a, const BvhNode& b) {
    return a.box == b.box && a.first == b.first && a.count == b.count;
}

bool same(const BvhTree& a, const BvhTree& b) {
    if (a.ids != b.ids || a.nodes.size() != b.nodes.size()) return false;
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        if (i != 1 && !same(a.nodes[i], b.nodes[i])) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("Given any primitives, each is in one leaf, of its kind, in boxes that nest") {
    for (const std::size_t count : {0U, 1U, 2U, 8U, 9U, 100U, 4095U, 4097U, 20000U}) {
        for (const Cast& cast : casts) {
            CAPTURE(count, &cast - casts);
            require_sound(cast(count), {});
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
                require_sound(primitives, config);
            }
        }
    }
}

TEST_CASE("Given another number of threads, the tree is the same", "[needs_two_cores]") {
    SKIP_UNLESS(max_threads() >= 2, "a single core");
    for (const Cast& cast : casts) {
        const Primitives primitives = cast(50'000);
        const auto built = [&](int threads) {
            const ThreadLimit limit(threads);
            return build_bvh(primitives);
        };
        CAPTURE(&cast - casts);
        const BvhTree alone = built(1);
        CHECK(same(alone, built(2)));
        CHECK(same(alone, built(7)));
    }
}

TEST_CASE("Given many triangles, most lanes of the leaves are taken") {
    const Primitives primitives = scattered(100'000);
    const Inspection found(build_bvh(primitives), primitives, {});
    CHECK(100 * primitives.size() > 85 * 8 * found.leaves);
}

TEST_CASE("Given primitives of a kind that is tested one by one, small leaves are divided") {
    Primitives primitives = scattered(8);
    CHECK(Inspection(build_bvh(primitives), primitives, {}).leaves == 1);
    for (BoundedPrimitive& p : primitives) p.kind = box_kind;
    CHECK(Inspection(build_bvh(primitives), primitives, {}).leaves == 8);
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
    const LeafWeights weights(default_leaf_costs(), triangle);
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
