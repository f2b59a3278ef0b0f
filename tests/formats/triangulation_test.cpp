#include "core/formats/triangulation.h"

#include <cmath>

#include "tests/catch.h"

using namespace etalon;

TEST_CASE("a concave polygon is cut into triangles of its own area") {
    const auto area = [](const std::vector<Vec3>& corners) {
        double sum = 0;
        for (const auto& [a, b, c] : triangulate(corners)) {
            const double part = (corners[b] - corners[a]).cross(corners[c] - corners[a]).z / 2;
            CHECK(part > 0);
            sum += part;
        }
        return sum;
    };
    CHECK(area({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}) == 10);
    CHECK(area({{2, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}}) == 10);
    std::vector<Vec3> star;
    for (int i = 0; i < 20; ++i) {
        const double r = i % 2 == 0 ? 3 : 1, angle = M_PI * i / 10;
        star.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    CHECK(area(star) == Approx(20 * 3 * 1 * std::sin(M_PI / 10) / 2));
    // A square with a square hole, to which a cut leads.
    CHECK(area({{0, 0, 0},
                {4, 0, 0},
                {4, 4, 0},
                {0, 4, 0},
                {0, 0, 0},
                {1, 1, 0},
                {1, 3, 0},
                {3, 3, 0},
                {3, 1, 0},
                {1, 1, 0}}) == 12);
}

TEST_CASE("a convex polygon is a fan about its first corner") {
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    CHECK(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}}) ==
          Triangles{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("a polygon that crosses itself still ends") {
    CHECK(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);
    CHECK(triangulate(std::vector<Vec3>(10000, Vec3(1))).size() == 9998);
}
