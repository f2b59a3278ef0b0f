// Selection of a light at a point, and its samples.
#include "core/light/lights.h"

#include <limits>
#include <numbers>

#include "core/image/io.h"
#include "core/sampling/sobol.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

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
    for (int i = 0; i < triangles; ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        look.bindings.push_back({.light = number});
        const double x = 2 * i;
        const std::uint32_t first = g.add_vertex({x, 0, 0});
        g.add_vertex({x + 1, 0, 0});
        g.add_vertex({x, 1, 0});
        g.add(Triangle{{first, first + 1, first + 2}}, number);
        look.lights.emplace_back(AreaSource{number, 1, Color(static_cast<float>(i + 1)), false});
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

TEST_CASE("Lights that take light away are picked like those that give it", "[light]") {
    for (const int triangles : {3, 40}) {
        const Scene scene = lit_scene(triangles);
        Scene mixed = scene;
        for (PhysicalLight& light : mixed.physical().lights) {
            if (auto* const area = std::get_if<AreaSource>(&light); area && area->first % 2)
                area->radiance = -area->radiance;
            if (auto* const point = std::get_if<PointSource>(&light)) point->intensity = Color(-1);
        }
        std::vector<std::string> problems;
        const Lights given(scene, problems), taken(mixed, problems);
        Receiver at{Vec3(1, 0.5, 1), Vec3(0, 0, -1)}, same = at;
        for (int i = 0; i < 100; ++i) {
            const auto pick = taken.pick(at, i / 100.0), expected = given.pick(same, i / 100.0);
            REQUIRE((pick && expected));
            CHECK((pick->light == expected->light && pick->probability == expected->probability));
        }
        for (std::uint32_t i = 0; i < given.size(); ++i) {
            CHECK(taken.pick_probability(at, i) == given.pick_probability(same, i));
        }
        const LightPick point = taken.pick_point_light(0.5);
        CHECK(point.light == static_cast<std::uint32_t>(triangles));
        CHECK(point.probability == 1);
    }
}

TEST_CASE("A light whose luminance is 0 by its signs is picked", "[light]") {
    Scene scene = lit_scene(2);
    scene.physical().lights.back() = PointSource{Vec3(0, 0, 3), Color(0.715160F, -0.212671F, 0)};
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    Receiver at{Vec3(1, 0.5, 1)};
    REQUIRE(lights.pick(at, 0));
    CHECK(lights.pick_probability(at, 2) > 0.01);
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

TEST_CASE("A light whose image is no number somewhere leaves the others there", "[light]") {
    const test::TemporaryFolder folder;
    const std::string file = folder / "lamp.exr";
    for (const float odd :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        RenderedImage image{4, 2, {{0, 0}, {3, 1}}, std::vector(8, Color(odd)), false, {}};
        REQUIRE(write_image(file, image).empty());
        for (const int triangles : {3, 40}) {
            Scene scene = lit_scene(triangles);
            scene.physical().lights.emplace_back(
                GoniometricSource{Vec3(0, 0, 2), Color(1), file, Affine{}});
            std::vector<std::string> problems;
            const Lights lights(scene, problems);
            REQUIRE(problems.empty());
            Receiver at{Vec3(1, 0.5, 1)};
            const auto lamp = static_cast<std::uint32_t>(lights.size() - 1);
            int lamps = 0;
            constexpr int count = 1024;
            for (int i = 0; i < count; ++i) {
                const auto pick = lights.pick(at, (i + 0.5) / count);
                REQUIRE(pick);
                CHECK(pick->probability > 0);
                lamps += pick->light == lamp;
            }
            CHECK(lamps > 0);
            CHECK(lamps < count);
        }
    }
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

TEST_CASE("A projection without an image lights a square", "[light]") {
    Scene scene = lit_scene(0);
    // The light's x, y and z are the world's z, x and y.
    const Affine to_light{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}};
    scene.physical().lights = {ProjectionSource{Vec3(0), Color(2), "", to_light, 0.5}};
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    const auto lit = [&](double x, double y, double z) {
        const Vec3 place(y, z, x);
        return lights.sample(0, place, {}).radiance.x * static_cast<float>(place.length2());
    };
    CHECK_THAT(lit(0, 0, 1), WithinRel(2.0F, 1e-6F));
    CHECK_THAT(lit(0.49, -0.49, 1), WithinRel(2.0F, 1e-6F));
    CHECK(lit(0.51, 0, 1) == 0);
    CHECK(lit(0, -0.51, 1) == 0);
    CHECK(lit(0, 0, -1) == 0);
}

TEST_CASE("A projection has its image's aspect, and its first row at the least y", "[light]") {
    const test::TemporaryFolder folder;
    const std::string file = folder / "slide.exr";
    RenderedImage image{4, 2, {{0, 0}, {3, 1}}, {}, false, {}};
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 4; ++x) image.pixels.emplace_back(Vec3(x, y, 1));
    }
    REQUIRE(write_image(file, image).empty());
    Scene scene = lit_scene(0);
    scene.physical().lights = {ProjectionSource{Vec3(0), Color(1), file, {}, 0.5}};
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    CHECK(problems.empty());
    const auto lit = [&](double x, double y) {
        const Vec3 place(x, y, 1);
        return lights.sample(0, place, {}).radiance * static_cast<float>(place.length2());
    };
    const auto is = [](const Color& a, const Color& b) { return (a - b).length() < 1e-3F; };
    // A window of 2 by 1 with texels of half a unit.
    CHECK(is(lit(-0.75, -0.25), Color(0, 0, 1)));
    CHECK(is(lit(0.75, -0.25), Color(3, 0, 1)));
    CHECK(is(lit(0.25, 0.25), Color(2, 1, 1)));
    CHECK(lit(1.01, 0) == Color(0));
    CHECK(lit(0, 0.51) == Color(0));
}

TEST_CASE("A goniometric light's rows are the angles from its y, its columns those from x to z",
          "[light]") {
    const test::TemporaryFolder folder;
    const std::string file = folder / "lamp.exr";
    RenderedImage image{8, 4, {{0, 0}, {7, 3}}, {}, false, {}};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) image.pixels.emplace_back(Vec3(column, row, 1));
    }
    REQUIRE(write_image(file, image).empty());
    Scene scene = lit_scene(0);
    // The light's x, y and z are the world's z, x and y.
    const Affine to_light{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}};
    const Vec3 position(1, -2, 3);
    scene.physical().lights = {GoniometricSource{position, Color(2), file, to_light}};
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    CHECK(problems.empty());
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) {
            CAPTURE(row, column);
            const double theta = pi * (row + 0.5) / 4, phi = 2 * pi * (column + 0.5) / 8;
            const double x = std::sin(theta) * std::cos(phi), y = std::cos(theta),
                         z = std::sin(theta) * std::sin(phi);
            const LightSample s = lights.sample(0, position + 2.0 * Vec3(y, z, x), {});
            const Color expected(static_cast<float>(column), static_cast<float>(row), 1);
            CHECK((s.radiance * 2.0F - expected).length() < 1e-3F);  // intensity 2, distance 2
        }
    }
}

TEST_CASE("Lights: given several of the same image, then it is read once", "[light]") {
    Scene scene;
    scene.look = PhysicalLook{};
    for (const char* const file : {"none.png", "other.png", "none.png"}) {
        scene.physical().lights.emplace_back(GoniometricSource{Vec3(0), Color(1), file, {}});
        scene.physical().lights.emplace_back(ProjectionSource{Vec3(0), Color(1), file, {}, 1});
    }
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    CHECK(lights.size() == 6);
    CHECK(problems.size() == 2);
}
