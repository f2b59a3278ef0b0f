#include "core/numerics/instruction_sets.h"

#include "core/intersect/shapes/polygon_outline.h"

#include <numbers>

#include "core/numerics/random.h"
#include "core/scene/polygon_list.h"
#include "tests/catch.h"
#include "tests/each_instruction_set.h"

using namespace etalon;

namespace {

/// Counts near 64, the corners per word, and 256, the corners per block.
constexpr std::size_t corner_counts[] = {8,   9,   11,  12,  31,  62,  63,  64,  65,  66,
                                         127, 128, 129, 144, 254, 255, 256, 257, 258, 600};

/// Sums of such numbers are exact, so that corners and edges lie exactly on rays.
Vec3 rounded(const Vec3& v) {
    constexpr double grid = 64;
    return {std::round(grid * v.x) / grid, std::round(grid * v.y) / grid,
            std::round(grid * v.z) / grid};
}

/// Returns corners around a centre at random distances, in a plane along two axes or perpendicular
/// to a random direction; or, every third time, anywhere in that plane, with edges that cross each
/// other.
std::vector<Vec3> random_outline(std::size_t count, Random& random) {
    Vec3 u(1, 0, 0), v(0, 1, 0);
    if (random.one_in(2)) orthonormal_basis(random.direction(), u, v);
    const bool crosses_itself = random.one_in(3), on_grid = random.one_in(2);
    const Vec3 middle = random.one_in(4) ? 1e5 * random.in_cube() : random.in_cube();
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = crosses_itself ? random.uniform() : double(i) / double(count);
        const double angle = 2 * std::numbers::pi * share, radius = 4 * random.uniform(0.25, 1);
        const Vec3 p = middle + radius * (std::cos(angle) * u + std::sin(angle) * v);
        corners.push_back(on_grid ? rounded(p) : p);
    }
    return corners;
}

/// Returns a ray at a corner, a point of an edge or its midpoint, or near the outline's centre;
/// some along an axis, some exactly through their target.
Ray random_ray(const std::vector<Vec3>& corners, Random& random) {
    const std::size_t i = random.index(corners.size());
    const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const std::array targets = {a, a + random.uniform() * (b - a), 0.5 * (a + b),
                                0.5 * (a + corners[corners.size() / 2])};
    const Vec3 target = targets[random.index(targets.size())];
    Vec3 direction = random.one_in(3) ? rounded(random.in_cube()) : random.direction();
    if (random.one_in(6)) {
        direction = Vec3(0);
        direction[random.axis()] = random.sign();
    }
    if (direction == Vec3(0)) direction.x = 1;
    if (random.one_in(16)) return {target + 1e9 * random.direction(), direction};
    return {target - 8.0 * direction, direction};
}

void scale(std::vector<Vec3>& corners, Ray& ray, double factor) {
    for (Vec3& corner : corners) corner *= factor;
    ray.origin *= factor;
}

/// Requires that a polygon's columns give the same result as its corners one by one. Returns
/// whether the ray is covered.
bool require_same(const std::vector<Vec3>& corners, const Ray& ray) {
    PolygonList list;
    list.push_back({corners});
    const StoredPolygon polygon = list[0];
    const RayQuery query(ray);
    CAPTURE(corners.size(), ray.origin, ray.direction);
    REQUIRE(polygon.columns.length > corners.size());
    const bool expected = covers(polygon.corners, query);
    REQUIRE(covers_by_columns(polygon, query) == expected);
    return expected;
}

void require_same_answers(int outlines, int rays) {
    int covered = 0, all = 0;
    for (const std::size_t count : corner_counts) {
        for (int seed = 0; seed < outlines; ++seed) {
            Random random(count, static_cast<std::uint64_t>(seed));
            const std::vector<Vec3> outline = random_outline(count, random);
            for (int i = 0; i < rays; ++i, ++all) {
                std::vector<Vec3> corners = outline;
                Ray ray = random_ray(corners, random);
                if (random.one_in(4)) {
                    scale(corners, ray,
                          std::ldexp(1.0, static_cast<int>(random.index(1000)) - 500));
                }
                if (random.one_in(8)) ray.direction *= std::ldexp(1.0, random.one_in(2) ? 90 : -90);
                covered += require_same(corners, ray);
            }
        }
    }
    CHECK(covered > all / 5);
    CHECK(covered < all * 4 / 5);
}

}  // namespace

TEST_CASE("covers_by_columns: given rays at corners and edges, then it is covers") {
    test::for_each_target([] { require_same_answers(8, 60); });
}

TEST_CASE("covers_by_columns: given very many rays at corners and edges, then it is covers",
          "[long]") {
    test::for_each_target([] { require_same_answers(700, 250); });
}

TEST_CASE("covers_by_columns: given numbers beyond all products, then it is covers") {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        std::vector<Vec3> corners = random_outline(12, random);
        Ray ray = random_ray(corners, random);
        scale(corners, ray, std::ldexp(1.0, random.one_in(2) ? 1018 : -1060));
        if (random.one_in(4)) ray.direction *= 0x1p-1000;
        if (random.one_in(4)) ray.origin[random.axis()] = random.sign() * 1.7e308;
        require_same(corners, ray);
    }
}

TEST_CASE("covers_by_columns: given a ray in the polygon's plane, then nothing is covered") {
    PolygonList list;
    std::vector<Vec3> corners;
    for (int i = 0; i < 100; ++i) {
        corners.push_back(rounded({std::cos(0.0625 * i), std::sin(0.0625 * i), 0}));
    }
    list.push_back({corners});
    for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 0.5, 0), Vec3(-1, 1, 0)}) {
        for (const Vec3& corner : corners) {
            REQUIRE_FALSE(covers_by_columns(list[0], RayQuery({corner - 4.0 * d, d})));
        }
    }
}
