#include "core/shading/hit_order.h"

#include <algorithm>
#include <set>

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// Hits in runs of neighbours: of few primitives or many, in instances and outside of them, and
/// none. Some numbers differ by a multiple of the size of the table of lists.
std::vector<Hit> random_hits(Random& random) {
    std::vector<Hit> hits;
    const std::size_t end = random.index(700);
    const std::size_t most = 1 + random.index(12);
    while (hits.size() < end) {
        Hit hit{1, random.index(most)};
        if (random.one_in(5)) hit.primitive += 128;
        if (random.one_in(3)) hit.instance = hit.primitive / 2;
        if (random.one_in(10)) hit = {infinity, no_index};
        hits.insert(hits.end(), 1 + random.index(9), hit);
    }
    return hits;
}

/// Checks that the order has each ray that hit something once.
void check_rays(const HitOrder& order, std::span<const Hit> hits) {
    std::set<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < hits.size(); ++i) {
        if (hits[i].primitive != no_index) expected.insert(i);
    }
    REQUIRE(order.size == expected.size());
    REQUIRE(order.rays.size() >= order.size);
    const std::span found = std::span(order.rays).first(order.size);
    CHECK(std::set(found.begin(), found.end()) == expected);
}

/// Checks that the runs come first, each of one primitive that no other run has.
void check_runs(const HitOrder& order, std::span<const Hit> hits) {
    std::set<std::uint32_t> primitives;
    std::uint32_t end = 0;
    for (const HitRun& run : order.runs) {
        CHECK(primitives.insert(run.primitive).second);
        REQUIRE((run.first == end && run.last > run.first && run.last <= order.size));
        end = run.last;
        for (std::uint32_t i = run.first; i < run.last; ++i) {
            const Hit& hit = hits[order.rays[i]];
            CHECK((hit.primitive == run.primitive && hit.instance == no_index));
        }
    }
    CHECK(order.in_runs == end);
}

}  // namespace

TEST_CASE("Rays are ordered by the primitives that they hit, batch after batch", "[shading]") {
    Random random(11);
    HitOrder order;
    std::size_t runs = 0;
    for (int batch = 0; batch < 300; ++batch) {
        const std::vector<Hit> hits = random_hits(random);
        order.find(hits);
        check_rays(order, hits);
        check_runs(order, hits);
        runs += order.runs.size();
    }
    CHECK(runs > 300);
}
