#include "core/numerics/instruction_sets.h"

#include "core/intersect/shapes/polygon.h"

#include <numbers>

#include "core/numerics/random.h"
#include "core/scene/polygon_list.h"
#include "tests/catch.h"
#include "tests/each_instruction_set.h"

using namespace etalon;

namespace {

constexpr std::size_t corner_counts[] = {8, 9, 10, 11, 12, 31, 40, 63, 144, 257, 600};

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

/// Requires that the projection of a polygon gives the same result as its corners one by one, if it
/// gives any. Returns that result.
Coverage require_same(const StoredPolygon& polygon, const Ray& ray) {
    const RayQuery query(ray);
    REQUIRE(polygon.columns.edges >= polygon.corners.size());
    if (polygon.facts.box.isEmpty()) return Coverage::unknown;
    const std::optional<PlanePassage> passage = plain_passage(polygon, query);
    if (!passage || !(passage->t >= 0)) return Coverage::unknown;
    const Coverage coverage = projected_coverage(polygon, *passage, query);
    if (coverage == Coverage::unknown) return coverage;
    CAPTURE(polygon.corners.size(), ray.origin, ray.direction);
    REQUIRE((coverage == Coverage::full) == covers(polygon.corners, query));
    return coverage;
}

Coverage require_same(const std::vector<Vec3>& corners, const Ray& ray) {
    PolygonList list;
    list.push_back({corners});
    return require_same(list[0], ray);
}

/// Numbers of rays by their result.
struct Results {
    void add(Coverage coverage) {
        ++(coverage == Coverage::none ? none : coverage == Coverage::full ? full : unknown);
    }
    double share(int count) const { return double(count) / (none + full + unknown); }

    int none = 0, full = 0, unknown = 0;
};

void check_each_result_above(double share, const Results& results) {
    CHECK(results.share(results.none) > share);
    CHECK(results.share(results.full) > share);
}

Results require_same_answers(int outlines, int rays) {
    Results results;
    for (const std::size_t count : corner_counts) {
        for (int seed = 0; seed < outlines; ++seed) {
            Random random(count, static_cast<std::uint64_t>(seed));
            const std::vector<Vec3> outline = random_outline(count, random);
            for (int i = 0; i < rays; ++i) {
                std::vector<Vec3> corners = outline;
                Ray ray = random_ray(corners, random);
                if (random.one_in(4)) {
                    scale(corners, ray,
                          std::ldexp(1.0, static_cast<int>(random.index(1000)) - 500));
                }
                if (random.one_in(8)) ray.direction *= std::ldexp(1.0, random.one_in(2) ? 90 : -90);
                results.add(require_same(corners, ray));
            }
        }
    }
    return results;
}

/// Requires the same results for rays that pass an edge at a distance of about the error bound. In
/// half of the outlines the corners are off the plane.
Results require_same_near_edges(int outlines, int rays) {
    Results results;
    for (int seed = 0; seed < outlines; ++seed) {
        Random random(7, static_cast<std::uint64_t>(seed));
        std::vector<Vec3> corners =
            random_outline(corner_counts[random.index(std::size(corner_counts))], random);
        const double off = random.one_in(2) ? 0 : std::exp2(-random.uniform(4, 40));
        for (Vec3& corner : corners) corner += off * random.in_cube();
        PolygonList list;
        list.push_back({corners});
        const Vec3 normal = normalized(list[0].facts.plane.normal);
        for (int i = 0; i < rays; ++i) {
            const std::size_t k = random.index(corners.size());
            const Vec3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
            const Vec3 on_edge = a + (random.one_in(4) ? 0 : random.uniform()) * (b - a);
            Vec3 direction = random.direction();
            if (random.one_in(3)) {
                const double kept = std::exp2(-random.uniform(0, 30));
                direction -= (1 - kept) * direction.dot(normal) * normal;
            }
            const double distance = std::exp2(random.uniform(-10, 30));
            const double error = std::max({off, 0x1p-34 * distance, 0x1p-48});
            const Vec3 target =
                on_edge + error * std::exp2(random.uniform(-3, 8)) * random.in_cube();
            results.add(require_same(list[0], {target - distance * direction, direction}));
        }
    }
    return results;
}

}  // namespace

TEST_CASE("projected_coverage: given rays at corners and edges, then it is covers or unknown") {
    test::for_each_target([] { check_each_result_above(0.04, require_same_answers(8, 60)); });
}

TEST_CASE(
    "projected_coverage: given very many rays at corners and edges, then it is covers or "
    "unknown",
    "[long]") {
    test::for_each_target([] { check_each_result_above(0.04, require_same_answers(700, 250)); });
}

TEST_CASE(
    "projected_coverage: given rays as far from edges as its error, then it is covers or "
    "unknown") {
    test::for_each_target([] { check_each_result_above(0.04, require_same_near_edges(400, 100)); });
}

TEST_CASE(
    "projected_coverage: given very many rays as far from edges as its error, then it is "
    "covers or unknown",
    "[long]") {
    test::for_each_target(
        [] { check_each_result_above(0.04, require_same_near_edges(40000, 100)); });
}

TEST_CASE("projected_coverage: given numbers beyond all products, then it is covers or unknown") {
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

TEST_CASE("projected_coverage: given rays at random points of a star, then it is always known") {
    std::vector<Vec3> corners;
    for (int i = 0; i < 40; ++i) {
        const double angle = std::numbers::pi * i / 20, radius = i % 2 == 0 ? 1 : 0.6;
        corners.push_back({radius * std::cos(angle), 0.25, radius * std::sin(angle)});
    }
    PolygonList list;
    list.push_back({corners});
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 target(random.uniform(-1, 1), 0.25, random.uniform(-1, 1));
        const Vec3 origin(random.uniform(-3, 3), 4, random.uniform(-3, 3));
        REQUIRE(require_same(list[0], {origin, target - origin}) != Coverage::unknown);
    }
}

TEST_CASE("covers: given a ray in the polygon's plane, then nothing is covered") {
    std::vector<Vec3> corners;
    for (int i = 0; i < 100; ++i) {
        corners.push_back(rounded({std::cos(0.0625 * i), std::sin(0.0625 * i), 0}));
    }
    PolygonList list;
    list.push_back({corners});
    for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 0.5, 0), Vec3(-1, 1, 0)}) {
        for (const Vec3& corner : corners) {
            const RayQuery query({corner - 4.0 * d, d});
            REQUIRE_FALSE(plain_passage(list[0], query));
            REQUIRE_FALSE(covers(list[0], std::nullopt, query));
        }
    }
}
