#include "core/formats/outline.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

using Outline = std::vector<Vec2>;

/// Returns points of a lattice, on which plain doubles are exact.
Outline scattered(int corners, Random& random) {
    Outline p;
    for (int i = 0; i < corners; ++i) {
        p.emplace_back(std::round(random.uniform(-9, 9)), std::round(random.uniform(-9, 9)));
    }
    return p;
}

/// Returns a star about the origin, which does not cross itself, on the same lattice.
Outline star(int corners, Random& random) {
    Outline p;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners, radius = random.uniform(100, 1000);
        p.emplace_back(std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle)));
    }
    return p;
}

bool has_crossing_pair(const Outline& p) {
    const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b - a).cross(c - a);
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
        for (std::size_t k = 0; k < i; ++k) {
            const Vec2 &c = p[k], &d = p[(k + 1) % p.size()];
            if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
        }
    }
    return false;
}

}  // namespace

TEST_CASE("an outline crosses itself where two edges do, not where they touch") {
    CHECK(crosses_itself({{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}));
    CHECK(crosses_itself({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    CHECK_FALSE(crosses_itself({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}));
    // A hole, to which a cut leads, and a corner on an edge.
    CHECK_FALSE(crosses_itself(
        {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}));
    CHECK_FALSE(crosses_itself({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));
    CHECK_FALSE(crosses_itself({{1, 1}, {1, 1}, {1, 1}}));
}

TEST_CASE("crossings are those found by testing all pairs of edges") {
    Random random(3);
    int crossing = 0;
    for (int i = 0; i < 2000; ++i) {
        const Outline p = i % 2 == 0 ? scattered(4 + i % 9, random) : star(4 + i % 60, random);
        const bool expected = has_crossing_pair(p);
        CHECK(crosses_itself(p) == expected);
        if (expected) ++crossing;
    }
    CHECK(crossing > 500);
    CHECK(crossing < 1500);
}

TEST_CASE("a projected outline runs counter-clockwise about each axis") {
    for (const bool turned : {false, true}) {
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<Vec3> corners(4, Vec3(0));
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i][axis] = 0.1 * static_cast<double>(i % 2);
                corners[i][(axis + 1) % 3] = i == 1 || i == 2 ? 1 : 0;
                corners[i][(axis + 2) % 3] = i >= 2 ? 1 : 0;
            }
            if (turned) std::swap(corners[1], corners[3]);
            const Outline p = projected_outline(corners);
            CHECK((p[1] - p[0]).cross(p[2] - p[0]) > 0);
        }
    }
}
