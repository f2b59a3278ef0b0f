#include "core/shading/seen_surfaces.h"

#include "core/intersect/kernels.h"
#include "core/numerics/random.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Shapes with and without a vectorised path, of two materials.
Scene some_shapes() {
    Scene scene;
    const Material glass{.diffuse = Color(1.0F), .transmission = Color(0.5F)};
    scene.look = WhittedLook{{Material{}, glass}, {}, {}};
    Geometry& g = scene.geometry;
    g.add(Sphere{Vec3(-1, 0, 0), 0.8}, 0);
    g.add(Box{Vec3(0.2, -0.5, -0.5), Vec3(1, 0.5, 0.5)}, 1);
    g.add(Plane{Vec3(0, -1, 0), Vec3(0, 2, 0)}, 1);
    g.add(Cone{Vec3(0, 1, 0), Vec3(0, 2, 0), 1, 0}, 0);
    return scene;
}

Hit nearest(const Geometry& geometry, const Ray& ray) {
    NearestHit nearest(ray.tmax);
    for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i) {
        nearest.offer(primitive_first_hit(geometry, i, RayQuery(ray)), i);
    }
    return {nearest.t, nearest.item};
}

void check_surface(const SeenSurfaces& seen, std::size_t i, const SurfaceInteraction& at,
                   const Ray& ray) {
    const auto left = static_cast<double>(exclusion_of(at.surface.primitive, at.surface.instance));
    const bool is_flat = at.surface.convexity == Convexity::flat;
    const bool is_convex = at.surface.convexity == Convexity::convex;
    CHECK(seen.directions[i] == ray.direction);
    CHECK(seen.positions[i] == at.surface.position);
    CHECK(seen.errors[i] == at.surface.error);
    CHECK(seen.normals[i] == at.surface.normal);
    CHECK(seen.shading_normals[i] == at.ns);
    CHECK(seen.entering(i) == at.entering);
    CHECK(seen.traits[i].material == at.material);
    CHECK(seen.outward_excludes[i] == (is_flat || is_convex ? left : no_index));
    CHECK(seen.inward_excludes[i] == (is_flat ? left : no_index));
    CHECK(seen.scatters[i] == at.surface.material);
    CHECK(seen.sends_on[i] == 2 * at.surface.material);
}

}  // namespace

TEST_CASE("Surfaces seen by many rays are those that each sees", "[shading]") {
    const Scene scene = some_shapes();
    for_each_target([&] {
        Random random(9);
        SeenSurfaces seen;
        for (const std::size_t count : {0U, 1U, 7U, 40U, 700U}) {
            std::vector<Ray> rays;
            std::vector<Hit> hits;
            std::size_t hit_count = 0;
            for (std::size_t i = 0; i < count; ++i) {
                Vec3 direction = random.direction();
                if (random.one_in(4)) direction[static_cast<int>(random.index(3))] = 0;
                rays.push_back({2.0 * random.in_cube(), direction});
                if (i % 9 == 0) rays.back() = {Vec3(0, 3, 0), Vec3(0, -1, 0)};  // at the apex
                hits.push_back(nearest(scene.geometry, rays[i]));
                hit_count += hits[i].primitive != no_index;
            }
            RayBuffer buffer;
            buffer.make_room(count);
            for (std::size_t i = 0; i < count; ++i) buffer.set(i, rays[i]);
            seen.find(scene, buffer.view(count), hits);
            REQUIRE(seen.size() == hit_count);
            std::vector<int> times(count, 0);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const std::uint32_t ray = seen.traits[i].ray;
                CAPTURE(count, i, ray, hits[ray].primitive);
                REQUIRE(++times[ray] == 1);
                check_surface(seen, i, surface_interaction(scene, rays[ray], hits[ray]), rays[ray]);
            }
        }
    });
}
