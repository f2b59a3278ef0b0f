#include "bench/hard_cases/random_scene.h"

#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/random_shapes.h"
#include "bench/hard_cases/ray_targets.h"
#include "core/scene/quadric_form.h"

namespace etalon::hard {
namespace {

/// Adds a concave or convex polygon of 4 to 7 corners around `place`.
void add_polygon(Scene& scene, const Vec3& place, double size, Sides sides, Random& random) {
    Vec3 u, v;
    orthonormal_basis(random.direction(), u, v);
    const std::size_t count = 4 + random.index(4);
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = turn * static_cast<double>(i) / static_cast<double>(count);
        const double radius = size * random.uniform(0.3, 1);
        corners.push_back(place + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    add_face(scene, corners, sides);
}

void add_triangle(Scene& scene, const Vec3& place, double size, Sides sides, Random& random) {
    const Vec3 b = place + size * random.in_cube();
    add_face(scene, {place, b, place + size * random.in_cube()}, sides);
}

void add_cone(Scene& scene, const Vec3& place, double size, Sides sides, Random& random) {
    const Vec3 top = place + size * random.in_cube();
    const double base_radius = size * std::max(0.0, random.uniform(-0.2, 0.5));
    scene.geometry.add(Cone{place, top, base_radius, size * random.uniform(0.1, 0.5)}, 0, sides);
}

void add_ring(Scene& scene, const Vec3& place, double size, Sides sides, Random& random) {
    const double outer = size * random.uniform(0.1, 1);
    const double inner = outer * std::max(0.0, random.uniform(-0.5, 0.9));
    scene.geometry.add(Ring{place, random.direction(), inner, outer}, 0, sides);
}

/// Adds a random quadric through the centre of its box or near it.
void add_quadric(Scene& scene, const Vec3& place, double size, Sides sides, Random& random) {
    const Vec3 half = abs(size * random.in_cube());
    Quadric s{place, {}, {place - half, place + half}};
    for (double& number : s.coefficients) number = random.uniform(-1, 1);
    s.coefficients[9] *= random.uniform();
    s.coefficients = scaled(s.coefficients, size);
    scene.geometry.add(s, 0, sides);
}

/// Returns a map that shears, and in half of all cases mirrors.
Affine any_map(const Vec3& place, double size, Random& random) {
    const Vec3 x = size * random.in_cube(), y = size * random.in_cube();
    return {x, y, size * random.in_cube(), place};
}

/// Adds a shape of a kind: a new shape needs a line here.
template <class Shape>
void add_shape(Scene& scene, double size, Sides sides, Random& random) {
    const Vec3 place = random.in_cube();
    if constexpr (std::is_same_v<Shape, Sphere>) {
        scene.geometry.add(Sphere{place, size * random.uniform(0.1, 1)}, 0, sides);
    } else if constexpr (std::is_same_v<Shape, Triangle>) {
        add_triangle(scene, place, size, sides, random);
    } else if constexpr (std::is_same_v<Shape, Polygon>) {
        add_polygon(scene, place, size, sides, random);
    } else if constexpr (std::is_same_v<Shape, Box>) {
        const Vec3 half = abs(size * random.in_cube());
        scene.geometry.add(Box{place - half, place + half}, 0, sides);
    } else if constexpr (std::is_same_v<Shape, Plane>) {
        scene.geometry.add(Plane{3.0 * place, random.direction()}, 0, sides);
    } else if constexpr (std::is_same_v<Shape, Cone>) {
        add_cone(scene, place, size, sides, random);
    } else if constexpr (std::is_same_v<Shape, Ring>) {
        add_ring(scene, place, size, sides, random);
    } else if constexpr (std::is_same_v<Shape, Revolved>) {
        scene.geometry.add(random_revolved(any_map(place, size, random), random), 0, sides);
    } else if constexpr (std::is_same_v<Shape, Quadric>) {
        add_quadric(scene, place, size, sides, random);
    } else if constexpr (std::is_same_v<Shape, Curve>) {
        scene.geometry.add(random_curve(any_map(place, size, random), random), 0, sides);
    } else {
        static_assert(std::is_same_v<Shape, Ellipsoid> || std::is_same_v<Shape, ClosedCylinder>);
        scene.geometry.add(Shape(any_map(place, size, random)), 0, sides);
    }
}

ShapeKind any_kind(const RandomSceneConfig& config, Random& random) {
    if (!config.kinds.empty()) return config.kinds[random.index(config.kinds.size())];
    const auto kind = static_cast<ShapeKind>(random.index(shape_kinds));
    // Only one in a hundred is a plane, since planes hide the rest.
    return kind == kind_of<Plane>() && random.index(8) != 0 ? kind_of<Sphere>() : kind;
}

}  // namespace

Scene random_scene(const RandomSceneConfig& config) {
    Scene scene;
    Random random(config.seed, 0);
    while (scene.geometry.primitives.size() < config.count) {
        const ShapeKind kind = any_kind(config, random);
        const double low = std::log10(config.smallest), high = std::log10(config.largest);
        const double size = random.magnitude(low, high);
        const Sides sides = config.one_sided ? static_cast<Sides>(random.index(3)) : Sides::both;
        with_shape(kind, [&]<class Shape>() { add_shape<Shape>(scene, size, sides, random); });
    }
    return scene;
}

}  // namespace etalon::hard
