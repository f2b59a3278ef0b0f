#include "tests/backends/trees.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/random.h"
#include "tests/catch.h"

namespace etalon {
namespace {

constexpr ShapeKind sphere = kind_of<Sphere>(), triangle = kind_of<Triangle>(),
                    box_kind = kind_of<Box>();

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

Primitives identical(std::size_t count) {
    return generate(count, [](Random&, std::size_t id) {
        return primitive(Vec3(0.25), Vec3(0.5), id, triangle);
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

bool contains(const Box3f& outer, const Box3f& inner) {
    return outer.intersects(inner.min) && outer.intersects(inner.max);
}

bool same(const BvhNode& a, const BvhNode& b) {
    return a.box == b.box && a.first == b.first && a.count == b.count;
}

}  // namespace

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

Primitives in_pairs(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const Vec3 place = random.in_cube();
        return primitive(Vec3(place.x > 0 ? 0.5 : -0.5), Vec3(0.1), id, id % 2 ? sphere : box_kind);
    });
}

Primitives concentric(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const double half = random.magnitude(-6, 0);
        return primitive(Vec3(0), Vec3(half), id, sphere);
    });
}

Primitives nested(std::size_t count) {
    return generate(count, [](Random& random, std::size_t id) {
        const double half = random.magnitude(-6, 0), away = half * random.uniform(10, 14),
                     angle = random.uniform(0, 6.28);
        const Vec3 centre(away * std::cos(angle), 0, away * std::sin(angle));
        return primitive(centre, Vec3(half), id, instance_kind);
    });
}

std::span<const Cast> all_casts() {
    static constexpr Cast casts[] = {scattered,  of_all_kinds, in_pairs, identical, concentric,
                                     in_a_plane, ever_closer,  denormal, nested};
    return casts;
}

Inspection::Inspection(const BvhTree& tree, const Primitives& primitives, const BvhConfig& config)
    : tree_(tree), primitives_(primitives), max_leaf_(config.max_leaf), seen(primitives.size()) {
    if (!tree.nodes.empty()) visit(tree.nodes[0], 0);
}

bool Inspection::each_once() const {
    return std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; });
}

void Inspection::visit(const BvhNode& node, int level) {
    ++nodes;
    depth = std::max(depth, level);
    if (node.is_leaf()) return visit_leaf(node);
    surface += half_area(node.box);
    for (std::uint32_t i : {node.first, node.first + 1}) {
        if (!contains(node.box, tree_.nodes[i].box)) ++outside_parent;
        visit(tree_.nodes[i], level + 1);
    }
}

void Inspection::visit_leaf(const BvhNode& node) {
    ++leaves;
    if (node.count > max_leaf_) ++too_large;
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

void require_sound(const BvhTree& tree, const Primitives& primitives, const BvhConfig& config) {
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

bool same(const BvhTree& a, const BvhTree& b) {
    if (a.ids != b.ids || a.nodes.size() != b.nodes.size()) return false;
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        if (i != 1 && !same(a.nodes[i], b.nodes[i])) return false;
    }
    return true;
}

}  // namespace etalon
