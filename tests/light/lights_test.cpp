// Which light is asked at a point, and what it says.
#include "core/light/lights.h"

#include <numbers>

#include "core/sampling/sobol.h"
#include "tests/catch.h"

using namespace etalon;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

/// A scene of so many triangles of light along x, all facing up, and a point light.
Scene lit_scene(int triangles) {
    Scene scene;
    scene.look = PhysicalLook{};
    PhysicalLook& look = scene.physical();
    look.materials = {{MatteMaterial{{Color(0.5F)}, {0}}}};
    Geometry& g = scene.geometry;
    look.bindings.push_back({.light = 0, .first = 0});
    for (int i = 0; i < triangles; ++i) {
        const double x = 2 * i;
        const std::uint32_t first = g.add_vertex({x, 0, 0});
        g.add_vertex({x + 1, 0, 0});
        g.add_vertex({x, 1, 0});
        g.add(Triangle{{first, first + 1, first + 2}}, 0);
        look.lights.emplace_back(
            AreaSource{static_cast<std::uint32_t>(i), Color(static_cast<float>(i + 1)), false});
    }
    look.lights.emplace_back(PointSource{Vec3(0, 0, 3), Color(1)});
    return scene;
}

}  // namespace

TEST_CASE("Lights are picked as often as their probabilities say", "[light]") {
    for (const int triangles : {3, 40}) {  // by importance, by power
        const Scene scene = lit_scene(triangles);
        std::vector<std::string> problems;
        const Lights lights(scene, problems);
        Receiver at{Vec3(1, 0.5, 1), Vec3(0, 0, -1)};
        constexpr int count = 1 << 14;
        std::vector<int> picked(lights.size());
        for (int i = 0; i < count; ++i) {
            const auto pick = lights.pick(at, (i + 0.5) / count);
            REQUIRE(pick);
            ++picked[pick->light];
            CHECK_THAT(lights.pick_probability(at, pick->light),
                       WithinRel(pick->probability, 1e-9));
        }
        double sum = 0;
        for (std::uint32_t i = 0; i < lights.size(); ++i) {
            const double p = lights.pick_probability(at, i);
            CHECK(std::abs(picked[i] / double{count} - p) < 2.0 / count);
            sum += p;
        }
        CHECK_THAT(sum, WithinRel(1.0, 1e-9));
    }
}

TEST_CASE("Of few lights none is picked that cannot shine on the point", "[light]") {
    const Scene scene = lit_scene(2);
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    Receiver behind{Vec3(1, 0.5, -1), Vec3(0, 0, 1)};
    for (const double u : {0.0, 0.3, 0.999}) CHECK(lights.pick(behind, u)->light == 2);
    CHECK(lights.pick_probability(behind, 0) == 0);
    Receiver away{Vec3(1, 0.5, 4), Vec3(0, 0, 1)};  // all are behind its surface
    CHECK_FALSE(lights.pick(away, 0.5));
}

TEST_CASE("The importance of a light is 0 only where it gives nothing", "[light]") {
    const Scene scene = lit_scene(3);
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    const ScrambledSobol points(9), directions(10);
    int lit = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const Vec2 u = points(i), v = directions(i);
        const double z = 1 - 2 * v.x, r = std::sqrt(1 - z * z);
        Receiver at{Vec3(8 * u.x - 2, 4 * u.y - 2, 2 * points(i + 50000).x - 0.5),
                    Vec3(r * std::cos(2 * pi * v.y), r * std::sin(2 * pi * v.y), z)};
        lights.pick(at, 0.5);
        for (std::uint32_t k = 0; k < lights.size(); ++k) {
            const LightSample s = lights.sample(k, at.position, directions(i + 777));
            if (!(s.pdf > 0) || !(at.normal.dot(s.wi) > 0)) continue;
            ++lit;
            CHECK(lights.pick_probability(at, k) > 0);
        }
    }
    CHECK(lit > 10000);
}

TEST_CASE("A point light falls off by the square of the distance", "[light]") {
    const Scene scene = lit_scene(1);
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    const LightSample s = lights.sample(1, Vec3(0, 0, 1), {});
    CHECK(s.is_delta);
    CHECK(s.wi == Vec3(0, 0, 1));
    CHECK(s.radiance == Color(0.25F));
}

TEST_CASE("A triangle of light shines from its front", "[light]") {
    for (const bool flipped : {false, true}) {
        Scene scene = lit_scene(1);
        scene.physical().bindings[0].flipped = flipped;
        std::vector<std::string> problems;
        const Lights lights(scene, problems);
        const double front = flipped ? -1 : 1;
        CHECK(lights.sample(0, Vec3(0.2, 0.2, front), {0.5, 0.5}).pdf > 0);
        CHECK(lights.sample(0, Vec3(0.2, 0.2, -front), {0.5, 0.5}).pdf == 0);
        SurfacePoint p;
        p.normal = Vec3(0, 0, 1);
        CHECK(lights.emitted(0, p, Vec3(0, 0, -front)) == Color(1));
        CHECK(lights.emitted(0, p, Vec3(0, 0, front)) == Color(0));
    }
}

TEST_CASE("A spot shines within its cone, and less towards the border", "[light]") {
    Scene scene = lit_scene(0);
    scene.physical().lights = {
        SpotSource{Vec3(0), Vec3(0, 0, 1), Color(1), std::cos(0.5), std::cos(0.4)}};
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    const auto at = [&](double angle) {
        return lights.sample(0, Vec3(std::sin(angle), 0, std::cos(angle)), {}).radiance.x;
    };
    CHECK_THAT(at(0.39), WithinRel(1.0F, 1e-6F));
    CHECK(at(0.45) < 1);
    CHECK(at(0.45) > 0);
    CHECK(at(0.51) == 0);
}
