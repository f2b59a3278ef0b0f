#include "core/shading/light_samples.h"

#include "tests/catch.h"
#include "tests/each_instruction_set.h"

using namespace etalon;

namespace {

const Light quad = QuadLight{Vec3(1, 2, 3), Vec3(4, 0, 0), Vec3(0, 0, 2), Color(1.0F), 12};

}  // namespace

TEST_CASE("Without pixel samples a quad light is a regular grid of all its points", "[shading]") {
    const LightSamples samples(quad, 0);
    REQUIRE(samples.count() == 12);
    CHECK(samples.color().x == Approx(1.0 / 12));
    // 12 = 3 x 4: the most nearly square grid, points at the middles of its cells.
    CHECK(samples.position(0) == Vec3(1 + 4 * (0.5 / 3), 2, 3 + 2 * (0.5 / 4)));
    Vec3 mean(0);
    for (int k = 0; k < 12; ++k) mean += samples.position(k) / 12;
    CHECK(mean.x == Approx(3));
    CHECK(mean.z == Approx(4));
}

TEST_CASE("With pixel samples a quad light's points are shared among them, rounded up",
          "[shading]") {
    CHECK(LightSamples(quad, 1).count() == 12);
    CHECK(LightSamples(quad, 5).is_random());
    CHECK(LightSamples(quad, 5).count() == 3);
    CHECK(LightSamples(quad, 5).color() == Color(1.0F / 3));
    CHECK(LightSamples(quad, 12).count() == 1);
    CHECK(LightSamples(quad, 100).count() == 1);
}

TEST_CASE("Random points of a quad light lie where their samples say", "[shading]") {
    test::for_each_target([] {
        const std::vector<Vec2> uvs(2 * padded_doubles, Vec2(0.25, 0.5));
        Vec3Buffer positions;
        for (const std::size_t count : {1, 3, 9}) {
            LightSamples(quad, 5).find_positions(std::span(uvs).first(count), positions);
            for (std::size_t i = 0; i < count; ++i) CHECK(positions[i] == Vec3(1 + 1, 2, 3 + 1));
        }
    });
}

TEST_CASE("A prime number of points makes one row", "[shading]") {
    const Light prime = QuadLight{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Color(1.0F), 7};
    const LightSamples samples(prime, 0);
    REQUIRE(samples.count() == 7);
    CHECK(samples.position(0).x == samples.position(6).x);
}

TEST_CASE("A point light is where it is", "[shading]") {
    const Light point = PointLight{Vec3(1, 2, 3), Color(0.5F)};
    const LightSamples samples(point, 16);
    CHECK(samples.count() == 1);
    CHECK(samples.color() == Color(0.5F));
    CHECK(samples.position(0) == Vec3(1, 2, 3));
}
