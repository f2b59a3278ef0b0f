// Lights sampled by a tree: as often as their probabilities state, and every light that
// contributes.
#include "core/light/light_tree.h"

#include <cmath>
#include <numbers>

#include "core/parallel/parallel.h"
#include "core/sampling/sobol.h"
#include "tests/catch.h"
#include "tests/chi_square.h"
#include "tests/light/uniform_direction.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

/// Small lights of all kinds in a cube of side 10.
std::vector<LightBounds> many_lights(std::uint32_t count) {
    const ScrambledSobol places(1), others(2), directions(3);
    std::vector<LightBounds> list;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec2 xy = places(i), zw = others(i);
        const Vec3 middle = 10.0 * Vec3(xy.x, xy.y, zw.x);
        const Vec3 half(i % 3 == 0 ? 0 : 0.1 * zw.y);
        const EmissionCone cone =
            i % 4 == 0 ? EmissionCone{{0, 0, 1}, pi, pi / 2, false}
            : i % 4 == 1
                ? EmissionCone{test::uniform_direction(directions(i)), 0, pi / 2, i % 8 == 1}
                : EmissionCone{test::uniform_direction(directions(i)), 0.2, 0.3, false};
        list.push_back({{middle - half, middle + half}, cone, i % 10 == 9 ? 0 : 0.1 + zw.y});
    }
    return list;
}

std::vector<Receiver> receivers() {
    const ScrambledSobol places(4), others(5), directions(6);
    std::vector<Receiver> list;
    for (std::uint32_t i = 0; i < 12; ++i) {
        const Vec2 xy = places(i);
        list.push_back({14.0 * Vec3(xy.x, xy.y, others(i).x) - Vec3(2),
                        i % 3 == 0 ? Vec3(0) : test::uniform_direction(directions(i))});
    }
    return list;
}

/// Returns whether a light at the centre of its bounds illuminates the receiver.
bool shines(const LightBounds& light, const Receiver& at) {
    const Vec3 way = light.box.center() - at.position;
    double cosine = -normalized(way).dot(light.cone.axis);
    if (light.cone.two_sided) cosine = std::abs(cosine);
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) - light.cone.spread;
    const bool is_received = at.normal == Vec3(0) || at.normal.dot(way) > 0;
    return light.intensity > 0 && angle < light.cone.emission && is_received;
}

}  // namespace

TEST_CASE("Lights are picked from a tree as often as their probabilities say", "[light]") {
    const double significance = test::sidak(0.01, 48);
    double worst = 0;
    for (const std::uint32_t count : {1U, 2U, 37U, 1000U}) {
        const std::vector<LightBounds> lights = many_lights(count);
        const LightTree tree(lights);
        for (const Receiver& at : receivers()) {
            constexpr int picks = 1 << 14;
            Random random(7);
            std::vector<double> picked(count + 1), expected(count + 1);
            for (int i = 0; i < picks; ++i) {
                const auto pick = tree.pick(at, random.uniform());
                ++picked[pick ? pick->light : count];
                if (!pick) continue;
                const double probability = tree.probability(at, pick->light);
                worst = std::max(worst, std::abs(probability / pick->probability - 1));
            }
            double sum = 0;
            for (std::uint32_t i = 0; i < count; ++i) {
                sum += tree.probability(at, i);
                expected[i] = picks * tree.probability(at, i);
            }
            CHECK(sum <= 1 + 1e-9);
            expected[count] = std::max(0.0, picks * (1 - sum));
            CHECK(test::chi_square_probability(picked, expected) > significance);
        }
    }
    CHECK(worst < 1e-9);
}

TEST_CASE("A tree picks every light that shines on a point", "[light]") {
    const std::vector<LightBounds> lights = many_lights(1000);
    const LightTree tree(lights);
    int lit = 0;
    for (const Receiver& at : receivers()) {
        for (std::uint32_t i = 0; i < lights.size(); ++i) {
            if (!shines(lights[i], at)) continue;
            ++lit;
            CHECK(tree.probability(at, i) > 0);
        }
        CHECK(tree.importance(at) > 0);
    }
    CHECK(lit > 1000);
}

TEST_CASE("Lights that fall off over more than a right angle are picked where they shine",
          "[light]") {
    const ScrambledSobol directions(7);
    std::vector<LightBounds> lights = many_lights(100);
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        lights[i].cone = {test::uniform_direction(directions(i)), 0.1 * (i % 3), 0.09 * (i % 34),
                          false};
    }
    const LightTree tree(lights);
    int lit = 0;
    for (const Receiver& at : receivers()) {
        double sum = 0;
        for (std::uint32_t i = 0; i < lights.size(); ++i) {
            const double probability = tree.probability(at, i);
            CHECK((probability >= 0 && probability <= 1));
            sum += probability;
            if (!shines(lights[i], at)) continue;
            ++lit;
            CHECK(probability > 0);
        }
        CHECK(sum <= 1 + 1e-9);
        CHECK(tree.importance(at) > 0);
    }
    CHECK(lit > 300);
}

TEST_CASE("A tree prefers what is near and turned to the point", "[light]") {
    const auto square = [](double x, const Vec3& axis) {
        return LightBounds{{{x - 0.1, -0.1, 0}, {x + 0.1, 0.1, 0}}, {axis, 0, pi / 2, false}, 1};
    };
    const LightTree tree({square(0, {0, 0, 1}), square(3, {0, 0, 1}), square(0.3, {0, 0, -1})});
    const Receiver above{{0, 0, 1}, {0, 0, -1}};
    CHECK(tree.probability(above, 0) > 5 * tree.probability(above, 1));
    CHECK(tree.probability(above, 1) > 0);
    CHECK(tree.probability(above, 2) == 0);
}

TEST_CASE("Lights in one place, and none at all, are no difficulty", "[light]") {
    const LightTree none({});
    CHECK_FALSE(none.pick({}, 0.5));
    CHECK(none.importance({}) == 0);
    const LightBounds point{Box3(Vec3(1)), {{0, 0, 1}, pi, 0, false}, 2};
    const LightTree tree(std::vector<LightBounds>(100, point));
    for (const Vec3& from : {Vec3(0), Vec3(1)}) {
        const Receiver at{from};
        double sum = 0;
        for (std::uint32_t i = 0; i < 100; ++i) sum += tree.probability(at, i);
        if (from == Vec3(0)) CHECK_THAT(sum, WithinAbs(1, 1e-9));
        CHECK(sum <= 1 + 1e-9);
    }
}

TEST_CASE("A tree of many lights is the same for any number of threads", "[light]") {
    const std::vector<LightBounds> lights = many_lights(20000);
    const auto made_by = [&](int threads) {
        const ThreadLimit limit(threads);
        return LightTree(lights);
    };
    const LightTree one = made_by(1), several = made_by(4);
    for (const Receiver& at : receivers()) {
        Random random(3);
        for (int i = 0; i < 1000; ++i) {
            const double choice = random.uniform();
            const auto a = one.pick(at, choice), b = several.pick(at, choice);
            REQUIRE(a.has_value() == b.has_value());
            if (!a) continue;
            CHECK(a->light == b->light);
            CHECK(a->probability == b->probability);
            CHECK(one.probability(at, a->light) == several.probability(at, a->light));
        }
    }
}

TEST_CASE("Bounds of lights added one by one are those of their unions", "[light]") {
    // Close to each other in direction, so that most are within the cone of those before.
    std::vector<LightBounds> lights = many_lights(4000);
    for (LightBounds& light : lights) {
        light.cone.axis = normalized(light.cone.axis + Vec3(0, 0, light.cone.two_sided ? -9 : 9));
        if (light.cone.spread == pi) light.cone.spread = 0;
    }
    BoundsSum sum;
    LightBounds expected;
    for (const LightBounds& light : lights) {
        sum.add(light);
        expected = united(expected, light);
        const LightBounds& found = sum.bounds();
        REQUIRE(found.box == expected.box);
        REQUIRE(found.cone.axis == expected.cone.axis);
        REQUIRE(found.cone.spread == expected.cone.spread);
        REQUIRE(found.cone.emission == expected.cone.emission);
        REQUIRE(found.cone.two_sided == expected.cone.two_sided);
        REQUIRE(found.intensity == expected.intensity);
    }
}

TEST_CASE("Bounds of two lights hold both", "[light]") {
    const std::vector<LightBounds> lights = many_lights(200);
    const auto within = [](const LightBounds& small, const LightBounds& large) {
        const double turn = std::acos(std::clamp(small.cone.axis.dot(large.cone.axis), -1.0, 1.0));
        const double angle = large.cone.two_sided ? std::min(turn, pi - turn) : turn;
        return angle + small.cone.spread <= large.cone.spread + 1e-6 || large.cone.spread >= pi;
    };
    for (std::size_t i = 0; i + 1 < lights.size(); ++i) {
        const LightBounds &a = lights[i], &b = lights[i + 1];
        if (!(a.intensity > 0) || !(b.intensity > 0)) continue;
        const LightBounds both = united(a, b);
        CHECK(within(a, both));
        CHECK(within(b, both));
        CHECK(both.cone.emission >= std::max(a.cone.emission, b.cone.emission));
        CHECK(both.box.intersects(a.box.min));
        CHECK(both.box.intersects(b.box.max));
        CHECK_THAT(both.intensity, WithinRel(a.intensity + b.intensity, 1e-12));
    }
}
