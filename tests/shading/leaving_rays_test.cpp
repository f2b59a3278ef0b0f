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

void check_surface(const LeavingRays& leaving, std::size_t i, const SurfaceInteraction& at,
                   const Vec3& direction, const LeavingRules& rules) {
    const Material& m = *at.material;
    const bool is_glass = m.transmission != Color(0.0F);
    if (m.reflection == Color(0.0F) && !is_glass) return;
    const Vec3 normal = direction.dot(at.ns) < 0 ? at.ns : at.ng;
    const Vec3 mirrored = normalized(reflect(direction, normal));
    CHECK(is_same(leaving.mirrored(i), leaving_alone(at, mirrored, rules.fixed_bias)));
    if (!is_glass) return;
    const double cosine = std::clamp(-direction.dot(normal), 0.0, 1.0);
    const double eta = at.entering ? 1 / m.ior : m.ior;
    const FresnelTerms fresnel =
        rules.schlick ? fresnel_schlick(eta, cosine) : fresnel_dielectric(eta, cosine);
    CHECK(leaving.reflectance(i) == fresnel.reflectance);
    CHECK(leaving.is_total(i) == fresnel.total);
    CHECK(leaving.enters(i) == at.entering);
    if (fresnel.total) return;
    const Vec3 refracted =
        normalized(refract(direction, normal, eta, cosine, fresnel.cos_refracted));
    CHECK(is_same(leaving.refracted(i), leaving_alone(at, refracted, -rules.fixed_bias)));
}

}  // namespace

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
                SeenSurfaces surfaces(count);
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
