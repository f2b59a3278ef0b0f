// Compares results for several rays at a time with those for single rays, for every instruction set
// that the machine has.
#include "core/intersect/local_rays.h"

#include <bit>

#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const Box3 world(Vec3(-3, 1, 2), Vec3(5, 2, 9));

double component(Random& random) {
    const double x = random.uniform(-1, 1);
    switch (random.index(40)) {
        case 0:
            return 0;
        case 1:
            return x * 0x1p-510;
        case 2:
            return x * 0x1p-1060;
        case 3:
            return x * 0x1p990;
        case 4:
            return x * 0x1p1020;
        case 5:
            return infinity;
        case 6:
            return nan_value;
        case 7:
            return -0.0;
        default:
            return x;
    }
}

/// Returns rays of all kinds: near and far, some of them invalid.
std::vector<Ray> all_kinds_of_rays(std::size_t count) {
    Random random(5);
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        const double distance = std::exp2(random.uniform(0, random.index(4) == 0 ? 40 : 4));
        const double length = std::exp2(random.uniform(-3, 3));
        for (int k = 0; k < 3; ++k) {
            ray.origin[k] = distance * component(random);
            ray.direction[k] = length * component(random);
        }
        if (random.index(8) == 0) ray.tmin = random.uniform(-1, 2);
        if (random.index(8) == 0) ray.tmax = random.uniform(-1, 2);
    }
    return rays;
}

bool same_bits(const Vec3f& a, const Vec3f& b) {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

void require_same(const NormalizedRay& together, const NormalizedRay& alone) {
    CHECK(same_bits(together.origin, alone.origin));
    CHECK(same_bits(together.direction, alone.direction));
    CHECK(together.shift == alone.shift);
    CHECK(together.scale == alone.scale);
}

/// Returns whether the ray hits the box by the plain slab test.
bool surely_meets(const Ray& ray) {
    double from = std::max(0.0, ray.tmin), to = ray.tmax;
    for (int k = 0; k < 3; ++k) {
        const double a = (world.min[k] - ray.origin[k]) / ray.direction[k];
        const double b = (world.max[k] - ray.origin[k]) / ray.direction[k];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

}  // namespace

TEST_CASE("Rays of a chunk are transformed to normalized space as single rays are", "[intersect]") {
    const NormalizedSpace space(world);
    const std::vector<Ray> rays = all_kinds_of_rays(100'000);
    for_each_target([&] {
        std::size_t entering = 0, passing = 0, alone = 0, size = 0;
        LocalRays chunk;
        for (std::size_t first = 0; first < rays.size(); first += size) {
            size = std::min(first % LocalRays::most + 1, rays.size() - first);
            chunk.set(space, RayColumns(std::span(rays).subspan(first, size)));
            for (std::size_t i = 0; i < size; ++i) {
                const Ray& ray = rays[first + i];
                CAPTURE(first, i, ray.origin, ray.direction);
                if (chunk.kind(i) == LocalRays::Kind::slow_path) {
                    ++alone;
                    continue;
                }
                REQUIRE(is_valid(ray));
                REQUIRE(space.resolves(ray));
                REQUIRE(chunk.dominant(i) == dominant_axis(ray.direction));
                const auto local = space.ray(ray);
                if (chunk.kind(i) == LocalRays::Kind::enters) {
                    ++entering;
                    REQUIRE(local);
                    require_same(chunk.ray(i), *local);
                } else {
                    ++passing;
                    REQUIRE_FALSE((local && surely_meets(ray)));
                }
            }
        }
        CHECK(entering > 5'000);
        CHECK(passing > 20'000);
        CHECK(alone > 5'000);
        CHECK(alone < 80'000);
    });
}

TEST_CASE("Nearly all ordinary rays are looked at together, and none where nothing is bounded",
          "[intersect]") {
    const std::vector<Ray> rays{{{0, 0, 0}, {0, 0, 1}},
                                {{9, 9, 9}, {1, 1e-200, 0}},
                                {{0, 0, 0}, {0, 0, 0}},
                                {{0, 0, 0}, {1, 0, 1e-300}}};
    const RayColumns columns(rays);
    CHECK(columns.common[0] != 0);
    CHECK(columns.common[1] == 0);
    CHECK(columns.common[2] == 0);
    CHECK(columns.common[3] == 0);

    LocalRays chunk;
    chunk.set(NormalizedSpace(), columns);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        CHECK(chunk.kind(i) == LocalRays::Kind::slow_path);
    }
}
