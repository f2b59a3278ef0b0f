#include "core/shading/highlights.h"

#include "core/numerics/random.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr double shininesses[] = {-1, 0, 1e-3, 0.5, 1, 2, 5, 30.1, 100, 200, 1000, 1e6, 1e300};

/// A surface lit at a random angle; every other one is where the highlight of a large exponent is
/// bright.
void add_lit(const Material& m, int i, Random& random, SeenSurfaces& to, Vec3Buffer& lights) {
    SurfaceInteraction at;
    at.surface.position = random.in_cube();
    at.surface.error = Vec3(0);
    at.surface.normal = at.ng = at.ns = random.direction();
    at.surface.convexity = Convexity::any;
    at.material = &m;
    at.entering = true;
    const Vec3 towards = normalized(at.ns + 0.9 * random.direction());
    const double side = random.uniform(0, 1) < 0.1 ? -1 : 1;
    lights.set(static_cast<std::size_t>(i), at.surface.position + side * towards);
    const Vec3 mirrored = 2 * at.ns.dot(towards) * at.ns - towards;
    const double spread = i % 2 == 0 ? 2 : 1 / (1 + std::sqrt(std::max(0.0, m.shininess)));
    to.add(at, -normalized(mirrored + random.uniform(0, spread) * random.direction()),
           static_cast<std::uint32_t>(i));
}

}  // namespace

TEST_CASE("A highlight of exponent 0 is everywhere, of a larger one only before the surface",
          "[shading]") {
    const Vec3 normal(0, 0, 1), down(0, 0, -1), behind = normalized(Vec3(4, 0, -3));
    for (const Highlight model : {Highlight::blinn, Highlight::phong}) {
        Material m;
        m.highlight = model;
        m.shininess = 0;
        const Vec3 direction = model == Highlight::blinn ? -down : down;
        CHECK(highlight(m, direction, normal, behind) == 1);
        m.shininess = 0.5;
        CHECK(highlight(m, direction, normal, behind) == 0);
        CHECK(highlight(m, down, normal, normal) == 1);
    }
}

TEST_CASE("Highlights found together are those of each shadow ray", "[shading]") {
    for_each_target([] {
        Random random(5);
        ShadowRays shadow;
        PaddedColumn<float> values;
        for (const double shininess : shininesses) {
            for (const Highlight model : {Highlight::blinn, Highlight::phong}) {
                Material m;
                m.diffuse = Color(1.0F);
                m.highlight = model;
                m.shininess = shininess;
                constexpr int count = 1000;
                SeenSurfaces surfaces;
                surfaces.reset(count);
                LightPoints lights;
                lights.each.make_room(count);
                for (int i = 0; i < count; ++i) add_lit(m, i, random, surfaces, lights.each);
                shadow.aim(surfaces, lights, 0);
                REQUIRE(shadow.size() > 800);
                values.make_room(shadow.size());
                for (std::size_t i = 0; i < shadow.size(); ++i) {
                    // Whole vectors of them in every other hundred.
                    shadow.blocked[i] = random.uniform(0, 1) < (i / 100 % 2 == 0 ? 0.9 : 0.1);
                    values[i] = -1;
                }
                for (std::size_t first = 0, last = 0; first < shadow.size(); first = last) {
                    last = std::min(shadow.size(),
                                    first + static_cast<std::size_t>(random.uniform(1, 20)));
                    find_highlights(m, surfaces, shadow, first, last, values);
                }
                for (std::size_t i = 0; i < shadow.size(); ++i) {
                    const std::size_t j = shadow.surface(i);
                    const auto alone = static_cast<float>(highlight(
                        m, surfaces.directions[j], surfaces.shading_normals[j], shadow.towards[i]));
                    CAPTURE(shininess, i);
                    if (shadow.blocked[i] == 0 && values[i] != alone) CHECK(values[i] == alone);
                }
            }
        }
    });
}
