#include "tests/intersect/scene_numbers.h"

#include <cmath>

#include "core/scene/quadric_form.h"

namespace etalon {
namespace {

template <class Shape>
constexpr bool is_affine = std::is_same_v<Shape, Ellipsoid> ||
                           std::is_same_v<Shape, ClosedCylinder> || std::is_same_v<Shape, Revolved>;

template <class Shape>
constexpr bool is_face = std::is_same_v<Shape, Triangle> || std::is_same_v<Shape, Polygon>;

/// Curves of a scene are immutable and are created again; the numbers of their maps are stored as
/// vertices of the scene in between.
void take_out_map(Geometry& geometry) {
    const Affine map = Curve(geometry.all<Curve>()[0]).to_world;
    geometry.vertices = {map.x, map.y, map.z, map.origin};
}

void put_back_map(Geometry& geometry) {
    Curve curve(geometry.all<Curve>()[0]);
    const auto& v = geometry.vertices;
    curve.to_world = {v[0], v[1], v[2], v[3]};
    geometry.all<Curve>() = {};
    geometry.all<Curve>().push_back(curve);
}

template <class Shape>
void list_numbers(Shape& s, std::vector<double*>& list) {
    const auto add = [&](Vec3& v) {
        for (int k = 0; k < 3; ++k) list.push_back(&v[k]);
    };
    if constexpr (std::is_same_v<Shape, Sphere>) {
        add(s.centre);
        list.push_back(&s.radius);
    } else if constexpr (std::is_same_v<Shape, Box>) {
        add(s.min);
        add(s.max);
    } else if constexpr (std::is_same_v<Shape, Plane>) {
        add(s.point);
        add(s.normal);
    } else if constexpr (is_affine<Shape>) {
        for (Vec3* v : {&s.to_world.x, &s.to_world.y, &s.to_world.z, &s.to_world.origin}) add(*v);
    } else if constexpr (std::is_same_v<Shape, Cone>) {
        add(s.base);
        add(s.top);
        list.push_back(&s.base_radius);
        list.push_back(&s.top_radius);
    } else if constexpr (std::is_same_v<Shape, Ring>) {
        add(s.centre);
        add(s.normal);
        list.push_back(&s.inner);
        list.push_back(&s.outer);
    } else {
        static_assert(std::is_same_v<Shape, Quadric>);
        add(s.centre);
        add(s.clip.min);
        add(s.clip.max);
        for (double& number : s.coefficients) list.push_back(&number);
    }
}

}  // namespace

std::vector<double*> numbers_of(Scene& scene) {
    std::vector<double*> list;
    Geometry& geometry = scene.geometry;
    with_shape(geometry.primitives[0].kind, [&]<class Shape>() {
        if constexpr (std::is_same_v<Shape, Curve>) take_out_map(geometry);
        if constexpr (is_face<Shape> || std::is_same_v<Shape, Curve>) {
            for (Vec3& v : geometry.vertices) list.insert(list.end(), {&v.x, &v.y, &v.z});
        } else {
            list_numbers(geometry.all<Shape>()[0], list);
        }
    });
    return list;
}

void finalize(Scene& scene) {
    with_shape(scene.geometry.primitives[0].kind, [&]<class Shape>() {
        auto& all = scene.geometry.all<Shape>();
        if constexpr (std::is_same_v<Shape, Revolved>) {
            all[0] = all[0].under(all[0].to_world);
        } else if constexpr (is_affine<Shape>) {
            all[0] = Shape(all[0].to_world);
        } else if constexpr (std::is_same_v<Shape, Curve>) {
            put_back_map(scene.geometry);
        } else if constexpr (std::is_same_v<Shape, Polygon>) {
            all = {};
            all.push_back({scene.geometry.vertices});
        }
    });
}

Scene scaled(Scene scene, int k) {
    for (double* number : numbers_of(scene)) *number = std::ldexp(*number, k);
    // A common factor does not change the quadric, and this loop gives them one.
    for (Quadric& s : scene.geometry.all<Quadric>()) {
        s.coefficients = scaled(s.coefficients, std::ldexp(1.0, k));
    }
    finalize(scene);
    return scene;
}

}  // namespace etalon
