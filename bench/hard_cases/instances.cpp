// Instances with maps for which the transformation of a ray to object space is ill conditioned.
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/closed_meshes.h"
#include "bench/hard_cases/random_scene.h"
#include "bench/hard_cases/ray_targets.h"
#include "core/numerics/transforms.h"
#include "core/scene/transformed.h"

namespace etalon::hard {
namespace {

using Kinds = std::vector<ShapeKind>;

/// Convex shapes: a ray that leaves one to the outside never hits it again, and a ray that goes
/// inside never hits it from the outside.
const Kinds convex = {kind_of<Sphere>(),        kind_of<Triangle>(), kind_of<Polygon>(),
                      kind_of<Box>(),           kind_of<Ring>(),     kind_of<Ellipsoid>(),
                      kind_of<ClosedCylinder>()};

/// All bounded shapes.
const Kinds bounded = [] {
    Kinds kinds = convex;
    kinds.insert(kinds.end(), {kind_of<Cone>(), kind_of<Quadric>(), kind_of<Revolved>()});
    return kinds;
}();

/// Returns an object of shapes in the cube [-1, 1]^3.
Geometry shapes(std::uint64_t seed, const Kinds& kinds = bounded) {
    return random_scene({.count = 24, .seed = seed, .kinds = kinds, .one_sided = true}).geometry;
}

/// Returns a map that stretches by 1, by the root of `condition` and by `condition`, along random
/// axes.
Affine stretch(double condition, Random& random) {
    const Affine first = rotation(random.uniform(0, 360), random.direction());
    const Affine second = rotation(random.uniform(0, 360), random.direction());
    const double root = std::sqrt(condition);
    return second * scaling({1 / root, 1, root}) * first;
}

/// Returns a scene of twenty instances of two objects, and a few primitives between them.
template <class Map>
Scene instances_of_shapes(const Map& map, const Kinds& kinds = bounded) {
    Scene scene = random_scene({.count = 12, .seed = 5, .kinds = kinds});
    scene.geometry.objects = {shapes(3, kinds), shapes(4, kinds)};
    Random random(19, 0);
    for (std::uint32_t i = 0; i < 20; ++i) {
        scene.geometry.instances.emplace_back(map(random), i % 2);
    }
    return scene;
}

Affine placed_at(const Vec3& place, Affine map) {
    map.origin = place;
    return map;
}

CaseSetup of_condition(double condition, const Kinds& kinds = bounded) {
    const auto map = [=](Random& random) {
        return placed_at(2.0 * random.in_cube(), stretch(condition, random));
    };
    return aimed_at_scene(instances_of_shapes(map, kinds));
}

CaseSetup mirrored() {
    return aimed_at_scene(instances_of_shapes([](Random& random) {
        return placed_at(2.0 * random.in_cube(), stretch(4, random) * scaling({1, -1, 1}));
    }));
}

/// Returns objects whose shapes are far from the origin of object space, in a scene far from the
/// origin of world space.
CaseSetup far_away(double distance) {
    const Vec3 far = distance * tilted(0.3, -0.5, 0.8);
    Scene scene;
    const Scene object = random_scene({.count = 24, .seed = 3, .kinds = {kind_of<Sphere>()}});
    scene.geometry.objects = {transformed(object, 1, far).geometry};
    Random random(23, 0);
    for (int i = 0; i < 20; ++i) {
        const Affine map = stretch(2, random);
        const Vec3 place = -far + 2.0 * random.in_cube();
        scene.geometry.instances.emplace_back(placed_at(place - map.vector(far), map), 0);
    }
    return aimed_at_scene(std::move(scene));
}

/// Returns instances that rotate by up to half a turn, are stretched and translated while the
/// shutter is open; about a third of them are only stretched and translated, and every fourth is
/// mirrored.
CaseSetup moving(const Kinds& kinds = bounded) {
    Scene scene = random_scene({.count = 12, .seed = 5, .kinds = kinds});
    scene.geometry.objects = {shapes(3, kinds), shapes(4, kinds)};
    scene.camera.sees_motion = true;
    Random random(47, 0);
    for (std::uint32_t i = 0; i < 20; ++i) {
        const Affine mirror = scaling({1, i % 4 == 0 ? -1.0 : 1.0, 1});
        const Affine start = placed_at(2.0 * random.in_cube(), stretch(3, random) * mirror);
        Affine end = i % 3 == 0 ? start : stretch(3, random) * mirror;
        end.origin = 2.0 * random.in_cube();
        const MotionTimes times{random.uniform(-1, 0.5), random.uniform(0.5, 2), 0, 1};
        scene.geometry.add_moving_instance(AnimatedTransform(start, end, times), i % 2);
    }
    return aimed_at_scene(std::move(scene));
}

/// Returns instances with singular and nearly singular maps among others.
CaseSetup singular() {
    int number = 0;
    return aimed_at_scene(instances_of_shapes([&](Random& random) {
        const double flat[] = {0, 1e-300, 1e-14, 1};
        return placed_at(2.0 * random.in_cube(), stretch(2, random)) *
               scaling({1, flat[number++ % 4], 1});
    }));
}

/// Returns many instances of one object, displaced by 1e-17 to 1e-6 of its size.
CaseSetup nearly_the_same() {
    Scene scene;
    scene.geometry.objects = {shapes(3)};
    Random random(29, 0);
    const Affine map = stretch(3, random);
    for (int i = 0; i < 20; ++i) {
        const Vec3 place = usual_place() + random.magnitude(-17, -6) * random.direction();
        scene.geometry.instances.emplace_back(placed_at(place, map), 0);
    }
    return aimed_at_scene(std::move(scene));
}

/// Returns many equal instances: the first one is hit.
CaseSetup copies() {
    Scene scene;
    scene.geometry.objects = {shapes(3)};
    Random random(31, 0);
    const Affine map = placed_at(usual_place(), stretch(3, random));
    for (int i = 0; i < 100; ++i) scene.geometry.instances.emplace_back(map, 0);
    return aimed_at_scene(std::move(scene));
}

/// Returns instances of objects with planes, which are unbounded.
CaseSetup unbounded() {
    Scene scene;
    scene.geometry.objects = {
        random_scene({.count = 12, .seed = 6, .kinds = {kind_of<Plane>(), kind_of<Sphere>()}})
            .geometry};
    Random random(37, 0);
    for (int i = 0; i < 8; ++i) {
        const Vec3 place = 2.0 * random.in_cube();
        scene.geometry.instances.emplace_back(placed_at(place, stretch(5, random)), 0);
    }
    return aimed_at_scene(std::move(scene));
}

/// Returns instances of sizes from 1e-4 to 1e4.
CaseSetup nested_sizes() {
    return aimed_at_scene(instances_of_shapes([](Random& random) {
        const double size = random.magnitude(-4, 4);
        return placed_at(random.magnitude(-2, 4) * random.direction(),
                         stretch(2, random) * scaling({size, size, size}));
    }));
}

/// A closed mesh seen from inside, under a map with that condition number; all rays are aimed at
/// vertices.
CaseSetup inside_mesh(double condition) {
    CaseSetup setup;
    setup.scene.geometry.objects = {uv_sphere(Vec3(0), Vec3(1), Faces::triangles).geometry};
    Random random(41, 0);
    const Affine map = placed_at(usual_place(), stretch(condition, random));
    setup.scene.geometry.instances.emplace_back(map, 0);
    const LargeVector<Vec3> corners = setup.scene.geometry.objects[0].vertices;
    setup.ray = [=](Random& choice) {
        const Vec3 from = map.point(0.5 * in_ball(choice));
        return towards(from, map.point(corners[choice.index(corners.size())]));
    };
    return setup;
}

}  // namespace

std::vector<HardCase> instance_cases() {
    Rows rows("scene");
    for (const int exponent : {0, 2, 4, 6, 8, 12}) {
        rows.add("INST-1", "condition " + power_of_ten(exponent),
                 [=] { return of_condition(std::pow(10, exponent)); });
    }
    rows.add("INST-1", "mirrored", mirrored);
    rows.add("INST-2", "1e3 sizes away", [] { return far_away(1e3); });
    rows.add("INST-2", "1e7 sizes away", [] { return far_away(1e7); });
    rows.add("INST-2", "sizes from 1e-4 to 1e4", nested_sizes);
    rows.add("INST-3", "singular", singular);
    rows.add("INST-3", "unbounded", unbounded);
    rows.add("INST-4", "nearly the same place", nearly_the_same);
    rows.add("INST-4", "copies", copies);
    for (const int exponent : {1, 4}) {
        rows.add(
            "INST-5", "closed mesh, condition " + power_of_ten(exponent),
            [=] { return inside_mesh(std::pow(10, exponent)); }, Criterion::enclosed);
        rows.add(
            "INST-6", "leaving, condition " + power_of_ten(exponent),
            [=] { return of_condition(std::pow(10, exponent), convex); }, Criterion::spawned);
    }
    rows.add(
        "INST-6", "leaving, 1e7 sizes away", [] { return far_away(1e7); }, Criterion::spawned);
    rows.add("INST-7", "moving", [] { return moving(); });
    rows.add(
        "INST-7", "leaving, moving", [] { return moving(convex); }, Criterion::spawned);
    return rows.take();
}

}  // namespace etalon::hard
