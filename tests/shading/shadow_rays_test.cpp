#include "core/shading/shadow_rays.h"

#include "core/numerics/random.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

SurfaceInteraction random_surface(Random& random) {
    constexpr Convexity kinds[] = {Convexity::any, Convexity::flat, Convexity::convex};
    SurfaceInteraction at;
    SurfacePoint& p = at.surface;
    p.position = random.in_cube();
    p.error = random.uniform(0, 1) < 0.1 ? Vec3(0) : Vec3(random.uniform(0, 1e-9));
    at.material = nullptr;
    p.normal = random.direction();
    p.primitive = 7;
    p.convexity = kinds[static_cast<int>(random.uniform(0, 3))];
    at.entering = random.uniform(0, 1) < 0.5;
    at.ng = at.entering ? p.normal : -p.normal;
    at.ns = normalized(at.ng + 0.3 * random.direction());
    return at;
}

/// A direction that is behind the surface's plane, or deviates from the plane by rounding errors
/// only.
Vec3 direction_behind(const SurfaceInteraction& at, Random& random) {
    const Vec3 within = at.ns.cross(random.direction());
    const double below = random.uniform(0, 1) < 0.5 ? random.uniform(0, 1) : 0x1p-52;
    return within - below * (random.uniform(0, 1) < 0.9 ? 1 : -1) * at.ns;
}

/// Points of a light far away, near the surface's plane, and on the surface. Of each 32 surfaces
/// the last 16 have only lights behind them or in their planes, near and far.
Vec3 random_light(const SurfaceInteraction& at, int i, Random& random) {
    const Vec3& p = at.surface.position;
    if (i % 32 >= 16)
        return p + std::pow(2, random.uniform(-500, 500)) * direction_behind(at, random);
    if (i % 8 == 0) return p;
    if (i % 8 == 1) return p + random.uniform(0, 1e-9) * random.direction();
    if (i % 8 == 2) return p + at.ng.cross(random.direction());
    return 10.0 * random.in_cube();
}

bool is_same(const Ray& a, const Ray& b) {
    return a.origin == b.origin && a.direction == b.direction && a.exclude == b.exclude;
}

}  // namespace

TEST_CASE("Shadow rays made together are those that leave each surface", "[shading]") {
    for_each_target([] {
        Random random(5);
        ShadowRays shadow;
        for (const std::size_t count : {0U, 1U, 5U, 64U, 5000U}) {
            std::vector<SurfaceInteraction> surfaces;
            std::vector<Vec3> lights;
            SeenSurfaces lit;
            lit.reset(count);
            LightPoints light_points;
            light_points.each.make_room(count);
            for (std::size_t i = 0; i < count; ++i) {
                surfaces.push_back(random_surface(random));
                lights.push_back(random_light(surfaces[i], static_cast<int>(i), random));
                light_points.each.set(i, lights[i]);
                lit.add(surfaces[i], Vec3(0), static_cast<std::uint32_t>(i));
            }
            shadow.aim(lit, light_points, 0);
            const RayStream rays = shadow.rays();
            std::size_t next = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const SurfaceInteraction& at = surfaces[i];
                const Vec3 towards = normalized(lights[i] - at.surface.position);
                CAPTURE(count, i, towards);
                if (!(at.ns.dot(towards) > 0) || !(at.ng.dot(towards) > 0)) continue;
                CHECK(shadow.first_from(i) == next);
                REQUIRE(next < rays.size());
                REQUIRE(shadow.surfaces[next] == static_cast<std::int64_t>(i));
                CHECK(shadow.towards[next] == towards);
                CHECK(shadow.cosines[next] == at.ns.dot(towards));
                CHECK(is_same(rays[next], spawn_ray_to(at.surface, lights[i])));
                CHECK(rays[next].tmax < 1);
                ++next;
            }
            CHECK(next == rays.size());
            CHECK(shadow.first_from(count) == next);
        }
    });
}

TEST_CASE("Shadow rays with a fixed bias start that far along the normal", "[shading]") {
    Random random(6);
    SeenSurfaces lit;
    lit.reset(20);
    std::vector<SurfaceInteraction> surfaces;
    for (std::uint32_t i = 0; i < 20; ++i) {
        lit.add(surfaces.emplace_back(random_surface(random)), Vec3(0), i);
    }
    const Vec3 light(100, 0, 0);
    ShadowRays shadow;
    shadow.aim(lit, {.is_one = true, .one = light, .each = {}}, 0.5);
    const RayStream rays = shadow.rays();
    CHECK(!rays.empty());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SurfaceInteraction& at = surfaces[shadow.surfaces[i]];
        CHECK(rays[i].origin == at.surface.position + 0.5 * at.ng);
        CHECK(rays[i].direction == light - rays[i].origin);
        CHECK(rays[i].exclude == no_index);
    }
}
