#include "core/formats/triangulation.h"

#include <cmath>

#include "tests/catch.h"

using namespace etalon;

namespace {

/// Returns the area of a polygon's triangles, none of which may be turned over.
double area(const std::vector<Vec3>& corners) {
    double sum = 0;
    for (const auto& [a, b, c] : triangulate(corners)) {
        const double part = (corners[b] - corners[a]).cross(corners[c] - corners[a]).z / 2;
        CHECK(part > 0);
        sum += part;
    }
    return sum;
}

/// Returns a band of constant width along a spiral, as many corners on either side.
std::vector<Vec3> spiral(int half) {
    std::vector<Vec3> corners;
    const auto add = [&](int step, double radius) {
        const double angle = step * (M_PI / 30);
        corners.push_back((radius + angle) * Vec3(std::cos(angle), std::sin(angle), 0));
    };
    for (int i = 0; i < half; ++i) add(i, 4);
    for (int i = half - 1; i >= 0; --i) add(i, 1);
    return corners;
}

double area_of_outline(const std::vector<Vec3>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p[i].cross(p[(i + 1) % p.size()]).z / 2;
    return sum;
}

}  // namespace

TEST_CASE("a concave polygon is cut into triangles of its own area") {
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

TEST_CASE("a concave polygon of thousands of corners is cut into triangles of its own area") {
    for (const int steps : {40, 2500, 20000}) {
        const std::vector<Vec3> corners = spiral(steps);
        CHECK(area(corners) == Approx(area_of_outline(corners)).epsilon(1e-9));
    }
}

TEST_CASE("many teeth, none of them along an axis, are cut into triangles of their own area") {
    std::vector<Vec3> corners = {{20001, 0, 0}, {20001, 20002, 0}};
    for (int i = 10000; i > 0; --i) {
        corners.emplace_back(2 * i - 1.5, 500 + 2 * i, 0);
        corners.emplace_back(2 * i - 1, 2 * i, 0);
    }
    corners.emplace_back(0, -1, 0);
    CHECK(area(corners) == Approx(area_of_outline(corners)).epsilon(1e-9));
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
