#include "core/shading/leaving_rays.h"

#include "core/numerics/random.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr Convexity kinds[] = {Convexity::any, Convexity::flat, Convexity::convex};

SurfaceInteraction random_surface(const std::vector<Material>& materials, const Vec3& direction,
                                  Random& random) {
    SurfaceInteraction at;
    SurfacePoint& p = at.surface;
    p.position = random.in_cube();
    p.error = Vec3(random.uniform(0, 1e-9));
    p.normal = random.direction();
    p.primitive = 3;
    p.convexity = kinds[static_cast<int>(random.uniform(0, 3))];
    at.material = &materials[static_cast<std::size_t>(random.uniform(0, 4))];
    at.entering = direction.dot(p.normal) < 0;
    at.ng = at.entering ? p.normal : -p.normal;
    at.ns = normalized(at.ng + random.uniform(0, 0.8) * random.direction());
    return at;
}

bool is_same(const Ray& a, const Ray& b) {
    return a.origin == b.origin && a.direction == b.direction && a.exclude == b.exclude &&
           a.tmin == b.tmin && a.tmax == b.tmax;
}

Ray leaving_alone(const SurfaceInteraction& at, const Vec3& direction, double bias) {
    return bias == 0 ? spawn_ray(at.surface, direction)
                     : Ray{at.surface.position + bias * at.ng, direction};
}

/// The rays written for one surface.
Ray mirrored(const LeavingRays& leaving, std::size_t i) {
    RayBuffer one;
    one.make_room(1);
    leaving.put_mirrored(LeavingRays::Choice{1} << i, one, 0);
    return one.view(1)[0];
}

Ray refracted(const LeavingRays& leaving, std::size_t i) {
    RayBuffer one;
    one.make_room(1);
    leaving.put_refracted(LeavingRays::Choice{1} << i, one, 0);
    return one.view(1)[0];
}

void check_surface(const LeavingRays& leaving, std::size_t i, const SurfaceInteraction& at,
                   const Vec3& direction, const LeavingRules& rules) {
    const Material& m = *at.material;
    const bool is_glass = m.transmission != Color(0.0F);
    const bool sends = m.reflection != Color(0.0F) || is_glass;
    REQUIRE((leaving.active() >> i & 1) == (sends ? 1 : 0));
    if (!sends) return;
    const Vec3 normal = direction.dot(at.ns) < 0 ? at.ns : at.ng;
    const Vec3 reflected = normalized(reflect(direction, normal));
    CHECK(is_same(mirrored(leaving, i), leaving_alone(at, reflected, rules.fixed_bias)));
    if (!is_glass) return;
    const double cosine = std::clamp(-direction.dot(normal), 0.0, 1.0);
    const double eta = at.entering ? 1 / m.ior : m.ior;
    const FresnelTerms fresnel =
        rules.schlick ? fresnel_schlick(eta, cosine) : fresnel_dielectric(eta, cosine);
    CHECK(leaving.reflectance(i) == fresnel.reflectance);
    CHECK(leaving.is_total(i) == fresnel.total);
    CHECK(leaving.enters(i) == at.entering);
    if (fresnel.total) return;
    const Vec3 bent = normalized(refract(direction, normal, eta, cosine, fresnel.cos_refracted));
    CHECK(is_same(refracted(leaving, i), leaving_alone(at, bent, -rules.fixed_bias)));
}

}  // namespace

TEST_CASE("Of rays that leave a chunk those chosen are written next to one another", "[shading]") {
    const std::vector<Material> materials(4, {.reflection = Color(0.5F)});
    for_each_target([&] {
        Random random(32);
        SeenSurfaces surfaces;
        surfaces.reset(50);
        for (std::uint32_t i = 0; i < 50; ++i) {
            const Vec3 direction = random.direction();
            surfaces.add(random_surface(materials, direction, random), direction, i);
        }
        LeavingRays leaving(surfaces, {false, 0});
        REQUIRE(leaving.make(0) == 50);
        const LeavingRays::Choice choice = 0x2'8000'f0f1'0003;
        RayBuffer written;
        written.make_room(50);
        leaving.put_mirrored(choice, written, 5);
        std::size_t next = 5;
        for (std::size_t i = 0; i < 50; ++i) {
            if ((choice >> i & 1) == 0) continue;
            CAPTURE(i, next);
            CHECK(is_same(written.view(50)[next++], mirrored(leaving, i)));
        }
        CHECK(next == 5 + 13);
    });
}

TEST_CASE("Rays that leave surfaces together are those that leave each", "[shading]") {
    const std::vector<Material> materials = {
        {},
        {.reflection = Color(0.5F)},
        {.transmission = Color(1.0F), .ior = 1.5},
        {.reflection = Color(0.1F), .transmission = Color(1.0F), .fresnel = true, .ior = 0.8}};
    for_each_target([&] {
        Random random(31);
        for (const LeavingRules& rules :
             {LeavingRules{false, 0}, LeavingRules{true, 0}, LeavingRules{false, 1e-4}}) {
            for (const std::size_t count : {0U, 1U, 9U, 300U}) {
                std::vector<SurfaceInteraction> alone;
                SeenSurfaces surfaces;
                surfaces.reset(count);
                for (std::uint32_t i = 0; i < count; ++i) {
                    const Vec3 direction = random.direction();
                    alone.push_back(random_surface(materials, direction, random));
                    surfaces.add(alone.back(), direction, i);
                }
                LeavingRays leaving(surfaces, rules);
                for (std::size_t first = 0; first < count;) {
                    const std::size_t made = leaving.make(first);
                    REQUIRE((made == LeavingRays::most || first + made == count));
                    for (std::size_t i = 0; i < made; ++i) {
                        CAPTURE(rules.schlick, rules.fixed_bias, count, first, i);
                        check_surface(leaving, i, alone[first + i], surfaces.directions[first + i],
                                      rules);
                    }
                    first += made;
                }
            }
        }
    });
}
