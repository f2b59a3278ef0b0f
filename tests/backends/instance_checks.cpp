#include "tests/backends/instance_checks.h"

#include <algorithm>

#include "core/intersect/placement.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

namespace etalon::test {

Hit all_tested(const Geometry& geometry, const Ray& ray) {
    Hit best{ray.tmax, no_index};
    const auto offer = [&](std::uint32_t primitive, std::uint32_t instance) {
        const double t = first_hit(geometry, key_of(primitive, instance), ray);
        const bool is_first = best.primitive == no_index && t <= ray.tmax && t < infinity;
        if (is_first || t < best.t) best = {t, primitive, instance};
    };
    for (std::uint32_t p = 0; p < geometry.primitives.size(); ++p) offer(p, no_index);
    for (std::uint32_t i = 0; i < geometry.instances.size(); ++i) {
        if (!geometry.instances[i].exists()) continue;
        for (std::uint32_t p = 0; p < geometry.holder(i).primitives.size(); ++p) offer(p, i);
    }
    return best;
}

std::size_t count_wrong(const Backend& backend, const Geometry& geometry,
                        const std::vector<Ray>& rays, const std::vector<Hit>& expected) {
    const auto intersector = backend.build(geometry);
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    intersector->closest(rays, hits);
    intersector->occluded(rays, blocked);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool is_hit = expected[i].primitive != no_index;
        const Hit alone = intersector->closest(rays[i]).value_or(Hit{0, no_index});
        TraversalCost cost;
        const Hit counted = intersector->closest(rays[i], cost).value_or(Hit{0, no_index});
        wrong += !same(hits[i], expected[i]) || !same(alone, expected[i]) ||
                 !same(counted, expected[i]) || (blocked[i] != 0) != is_hit ||
                 intersector->occluded(rays[i]) != is_hit;
    }
    return wrong;
}

int check_all(const Geometry& geometry, const std::vector<Ray>& rays) {
    std::vector<Hit> expected;
    for (const Ray& ray : rays) expected.push_back(all_tested(geometry, ray));
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        CHECK(count_wrong(backend, geometry, rays, expected) == 0);
    }
    return static_cast<int>(
        std::ranges::count_if(expected, [](const Hit& hit) { return hit.primitive != no_index; }));
}

}  // namespace etalon::test
