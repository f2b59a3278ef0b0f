// Every shape with random parameters, with rays aimed at all its targets from all around.
#include <memory>

#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/face_ray_targets.h"
#include "bench/hard_cases/ray_generators.h"
#include "bench/hard_cases/ray_targets.h"
#include "core/scene/profiles.h"

namespace etalon::hard {
namespace {

struct Example {
    const char* name;
    Extent extent;
    std::shared_ptr<const Scene> scene;
};

template <class Shape>
Example example(const char* name, const Extent& extent, const Shape& shape) {
    Scene scene;
    scene.geometry.add(shape, 0);
    return {name, extent, std::make_shared<Scene>(std::move(scene))};
}

Example sphere(const char* name, const Sphere& s) {
    return example(name, {s.centre, s.radius}, s);
}

Example cone(const char* name, const Cone& c) {
    const double widest = std::max(c.base_radius, c.top_radius);
    return example(name, {0.5 * (c.base + c.top), (c.top - c.base).length() + widest}, c);
}

template <class Shape>
Example image(const char* name, const Affine& map) {
    const double size = map.x.length() + map.y.length() + map.z.length();
    return example(name, {map.point({0, 0, 0.5}), size}, Shape(map));
}

Example revolved(const char* name, const Affine& map, const Profile& curve, double degrees) {
    const double size = map.x.length() + map.y.length() + map.z.length();
    return example(name, {map.origin, size}, Revolved(map, curve, Sector(degrees)));
}

/// Returns an example of a straight curve: a ray that leaves a bent one may hit it again.
Example curve(const char* name, CurveType type, const Affine& map) {
    BezierCurve c{
        {Vec3f(-1, 0, 0), Vec3f(-0.5F, 0.25F, 0), Vec3f(0, 0.5F, 0), Vec3f(0.5F, 0.75F, 0)},
        {0.5F, 0.25F}};
    c.normals = {Vec3f(0, 0, 1), Vec3f(0, 1, 0)};
    c.type = type;
    const double size = map.x.length() + map.y.length() + map.z.length();
    return example(name, {map.origin, size}, Curve(c, map));
}

Example box(const char* name, const Box& b) {
    return example(name, {0.5 * (b.min + b.max), (b.max - b.min).length() / 2}, b);
}

Example plane(const char* name, const Plane& p) {
    return example(name, {p.point, 1}, p);
}

Example ring(const char* name, const Ring& r) {
    return example(name, {r.centre, r.outer}, r);
}

/// Returns an example of a quadric within a distance of 1 from its centre along every axis.
Example quadric(const char* name, const Vec3& centre, const std::array<double, 10>& form) {
    const Quadric s{centre, form, {centre - Vec3(1), centre + Vec3(1)}};
    return example(name, {s.centre, 1}, s);
}

Example face(const char* name, const Corners& corners) {
    Scene scene;
    add_face(scene, corners);
    Box3 around;
    for (const Vec3& corner : corners) around.extendBy(corner);
    return {name,
            {around.center(), around.size().length() / 2},
            std::make_shared<Scene>(std::move(scene))};
}

std::vector<Example> rounded_shapes() {
    const Vec3 far = far_place(), base(0.3, -0.7, 0.45);
    const Affine sheared{{1, 0, 0.25}, {0.5, 1, 0}, {-2, 3, 1}, base};
    const Affine mirrored{tilted(-1, 0, 0), tilted(0, 0.5, 0), tilted(0, 0, 2), far};
    return {
        sphere("sphere", {base, 1}),
        sphere("sphere, planet", {{0, 0, -6.4e6}, 6.4e6}),
        sphere("sphere at 3e5", {far, 2}),
        cone("cylinder", {base, base + tilted(0, 0, 21.4), 1, 1}),
        cone("cylinder along an axis", {{0, 0, 0}, {0, 3, 0}, 0.5, 0.5}),
        cone("cylinder, needle", {base, base + tilted(0, 0, 1e3), 1e-3, 1e-3}),
        cone("cone", {base, base + tilted(0, 0, 2), 1, 0}),
        cone("cone along an axis", {{0, 0, 0}, {0, 0, 2}, 1, 0}),
        cone("cone, truncated", {base, base + tilted(0, 0, 3), 0.5, 1.5}),
        cone("cone, all but a cylinder", {base, base + tilted(0, 0, 3), 1, 1 + 0x1p-40}),
        cone("cone, all but a disk", {base, base + tilted(0, 0, 1e-4), 1, 0}),
        cone("cone at 3e5", {far, far + tilted(0, 0, 3), 2, 1}),
        quadric("quadric, sphere", base, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}),
        quadric("quadric, sphere at 3e5", far, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}),
        quadric("quadric, ellipsoid", base, {2, 0.5, 0.25, 0, 4, -0.5, 0, 9, 0, -1}),
        quadric("quadric, thin ellipsoid", base, {2, 0.5, 0.25, 0, 4, -0.5, 0, 1e6, 0, -1}),
        quadric("quadric, cylinder", base, {1, 0, 0, 0, 2, 0, 0, 0, 0, -0.5}),
        quadric("quadric, cone", base, {1, 0.1, 0, 0, 2, 0, 0, -1, 0, 0}),
        quadric("quadric, hyperboloid", base, {1, 0.1, 0, 0, 2, 0, 0, -1, 0, -0.125}),
        quadric("quadric, saddle at 3e5", far, {1, 0.1, 0, 0, -2, 0, 0, 0, 0.5, 0}),
        image<Ellipsoid>("ellipsoid", sheared),
        image<Ellipsoid>("ellipsoid, mirrored", mirrored),
        image<ClosedCylinder>("closed cylinder", sheared),
        image<ClosedCylinder>("closed cylinder, mirrored", mirrored),
        revolved("revolved, part of a sphere", sheared, profiles::sphere(-0.5, 0.75), 200),
        revolved("revolved, cylinder", mirrored, profiles::cylinder(), 360),
        revolved("revolved, sector of a ring", mirrored, profiles::disk(0.25), 120),
        curve("curve, flat", CurveType::flat, sheared),
        curve("curve, ribbon", CurveType::ribbon, mirrored),
        curve("curve, cylinder", CurveType::cylinder, sheared),
    };
}

std::vector<Example> flat_shapes() {
    const Vec3 far = far_place(), base(0.3, -0.7, 0.45);
    return {
        face("triangle", {tilted(0, 0, 1), tilted(2, 0.25, 1), tilted(0.5, 1.5, 1)}),
        face("triangle across an axis", {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}),
        face("triangle, sliver", {tilted(0, 0, 0), tilted(1, 0, 0), tilted(0.5, 1e-9, 0)}),
        face("triangle at 3e5", moved({{0, 0, 0}, {2, 0.25, 0.5}, {0.5, 1.5, 0}}, far)),
        face("polygon, quad", {tilted(0, 0, 1), tilted(2, 0, 1), tilted(2, 1, 1), tilted(0, 1, 1)}),
        face("polygon, notched", {{0, 0, 3}, {4, 0, 3}, {4, 4, 3}, {2, 2, 3}, {0, 4, 3}}),
        face("polygon, star", star(7, 0.4)),
        face("polygon, circle", star(40, std::cos(turn / 80))),
        face("polygon, corners off the plane",
             {{0, 0, 1e-6}, {2, 0, -1e-6}, {2, 1, 1e-6}, {0.5, 1.5, 0}, {0, 1, -1e-6}}),
        face("polygon at 3e5", moved(star(5, 0.3), far)),
        box("box", {{-1, -1, -1}, {1, 1, 1}}),
        box("box, odd", {{0.1, -0.7, 0.3}, {0.2, 1.9, 7.7}}),
        box("box, no thickness", {{-1, 0.1, -1}, {1, 0.1, 2}}),
        box("box at 3e5", {far, far + Vec3(1, 2, 0.3)}),
        plane("plane", {tilted(0.2, 0.3, 0.4), tilted(0.1, 0.2, 3)}),
        plane("plane across an axis", {{0, 0, 1}, {0, 0, 1}}),
        plane("plane at 3e5", {far, tilted(0.4, 0.1, 1)}),
        ring("ring", {base, tilted(0, 0.1, 1), 0.5, 1}),
        ring("ring at 3e5", {far, tilted(0, 0.1, 1), 0.5, 2}),
        ring("ring, no hole, across an axis", {base, {0, 0, -2}, 0, 1}),
    };
}

/// Returns whether the shape has an apex, where a surface has no sides that a ray could leave.
bool has_tip(const Scene& scene) {
    return !scene.geometry.all<Cone>().empty() && scene.geometry.all<Cone>()[0].top_radius == 0;
}

/// Returns whether a ray that leaves the shape to the outside may hit it again.
bool is_concave(const Scene& scene) {
    if (scene.geometry.all<Quadric>().empty()) return false;
    const auto& form = scene.geometry.all<Quadric>()[0].coefficients;
    return form[0] < 0 || form[4] < 0 || form[7] < 0;
}

using MakeAimedRay = Ray (*)(const Extent&, const Target&, Random&);

CaseSetup shot_at(const Example& e, MakeAimedRay ray) {
    const std::vector<Target> targets = targets_of(e.scene->geometry, 0, to_the_last_bit);
    // The targets refer to the scene, so the rays keep it alive.
    return {*e.scene, e.extent.size, [=, scene = e.scene, extent = e.extent](Random& random) {
                const std::size_t chosen = random.index(targets.size());
                return ray(extent, targets[chosen], random);
            }};
}

void add_rows(const Example& e, std::vector<HardCase>& cases) {
    Rows rows{std::string(kind_name(e.scene->geometry.primitives[0].kind))};
    rows.add("AIM-1", e.name, [e] { return shot_at(e, ray_generator); });
    rows.add("AIM-2", e.name, [e] { return shot_at(e, leave); });
    rows.add("AIM-3", e.name, [e] { return shot_at(e, through_two); });
    if (!has_tip(*e.scene) && !is_concave(*e.scene)) {
        rows.add(
            "SPN-0", e.name, [e] { return shot_at(e, ray_generator); }, Criterion::spawned);
    }
    for (HardCase& c : rows.take()) cases.push_back(std::move(c));
}

}  // namespace

std::vector<HardCase> aimed_cases() {
    std::vector<HardCase> cases;
    for (const Example& e : rounded_shapes()) add_rows(e, cases);
    for (const Example& e : flat_shapes()) add_rows(e, cases);
    return cases;
}

}  // namespace etalon::hard
