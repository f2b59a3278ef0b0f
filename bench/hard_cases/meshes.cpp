// Closed surfaces seen from inside, and a terrain from above: a ray that misses has leaked.
#include <memory>

#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/closed_meshes.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {
namespace {

struct Ellipsoid {
    const char* name;
    Vec3 centre, radius;
    Faces faces = Faces::triangles;
};

/// Rays from within half of the radius to a point of any face.
CaseSetup seen_from_inside(const Ellipsoid& e, Feature feature) {
    const auto mesh = std::make_shared<const Scene>(uv_sphere(e.centre, e.radius, e.faces));
    return {*mesh, max_abs(e.radius), [=](Random& random) {
                const Vec3 origin = e.centre + 0.5 * e.radius * in_ball(random);
                const auto face =
                    static_cast<std::uint32_t>(random.index(mesh->geometry.primitives.size()));
                return towards(origin, point_of(Outline(mesh->geometry, face), feature, random));
            }};
}

/// Rays from 2 to 20 above the target, displaced sideways by at most half of that, so that their
/// slope is at least 2; the steepest facet has a slope of sqrt(2). Targets are so far inside the
/// outline that origins are inside too.
CaseSetup seen_from_above(const Vec3& corner, Feature feature) {
    const auto ground = std::make_shared<const Scene>(terrain(corner));
    return {*ground, terrain_cells, [=](Random& random) {
                const auto column =
                    static_cast<std::uint32_t>(12 + random.index(terrain_cells - 24));
                const auto row = static_cast<std::uint32_t>(12 + random.index(terrain_cells - 24));
                const std::uint32_t half = random.index(2) == 0 ? 0 : 1;
                const std::uint32_t face = terrain_face(column, row) + half;
                const Vec3 target = point_of(Outline(ground->geometry, face), feature, random);
                const double height = random.uniform(2, 20);
                const Vec3 beside = 0.5 * in_disc({0, 0, 1}, random);
                return towards(target + height * (beside + Vec3(0, 0, 1)), target);
            }};
}

struct RayTarget {
    const char* id;
    const char* name;
    Feature feature;
};

constexpr RayTarget ray_targets[] = {
    {"TRI-3", "vertices", Feature::vertices},
    {"TRI-2", "edges", Feature::edges},
    {"TRI-2", "middles of edges", Feature::middles},
    {"TRI-2", "points", Feature::points},
};

}  // namespace

std::vector<HardCase> mesh_cases() {
    const Ellipsoid near[] = {
        {"sphere", {0, 0, 0}, Vec3(1)},
        {"sliver 1:1:1e3", {0, 0, 0}, {1, 1, 1e3}},
        {"sliver 1e-3:1:1e3", {0, 0, 0}, {1e-3, 1, 1e3}},
    };
    const Ellipsoid far{"sphere at 3e5", far_place(), Vec3(2)};
    const Ellipsoid mixed{"sphere of quads and triangles", {0, 0, 0}, Vec3(1), Faces::mixed};
    const Vec3 origin(-128, -128, 0), far_corner(1e5, -1e5, 1e5);

    Rows rows("scene");
    for (const RayTarget& ray_target : ray_targets) {
        const auto add = [&](const char* id, const std::string& mesh, const MakeCaseSetup& make) {
            rows.add_both(id, mesh + ": " + ray_target.name, make, Criterion::enclosed);
        };
        const Feature feature = ray_target.feature;
        for (const Ellipsoid& e : near) {
            add(ray_target.id, e.name, [=] { return seen_from_inside(e, feature); });
        }
        add(ray_target.id, "terrain", [=] { return seen_from_above(origin, feature); });
        add("TRI-4", far.name, [=] { return seen_from_inside(far, feature); });
        add("TRI-4", "terrain at 1e5", [=] { return seen_from_above(far_corner, feature); });
        add("POL-1", mixed.name, [=] { return seen_from_inside(mixed, feature); });
    }
    return rows.take();
}

}  // namespace etalon::hard
