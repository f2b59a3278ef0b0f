#include "core/scene/primitive_runs.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

bool same(const Primitive& a, const Primitive& b) {
    return a.kind == b.kind && a.sides == b.sides && a.index == b.index &&
           a.material == b.material && a.normal_offset == b.normal_offset;
}

/// Primitives in runs of random lengths from 1 to `longest`.
std::vector<Primitive> statements(std::size_t longest, std::uint64_t seed) {
    Random random(seed, 0);
    std::vector<Primitive> all;
    std::array<std::uint32_t, 3> next{};
    while (all.size() < 2000) {
        const auto kind = static_cast<ShapeKind>(random.index(3));
        const auto sides = static_cast<Sides>(random.index(3));
        const auto material = static_cast<std::uint32_t>(random.index(4));
        for (std::size_t left = 1 + random.index(longest); left > 0; --left) {
            all.push_back({kind, sides, next[kind]++, material});
        }
    }
    return all;
}

}  // namespace

TEST_CASE("PrimitiveRuns: given statements of any length, then each primitive is found again") {
    for (const std::size_t longest : {1U, 3U, 100U, 1000U}) {
        const std::vector<Primitive> all = statements(longest, longest);
        const PrimitiveRuns runs(all);
        REQUIRE(runs.size() == all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            CAPTURE(longest, i);
            REQUIRE(same(runs[i], all[i]));
        }
    }
}

TEST_CASE("PrimitiveRuns: given primitives in any order, then each primitive is found again") {
    std::vector<Primitive> all = statements(10, 5);
    Random random(6, 0);
    for (std::size_t i = all.size() - 1; i > 0; --i) std::swap(all[i], all[random.index(i + 1)]);
    const PrimitiveRuns runs(all);
    std::size_t i = 0;
    for (const Primitive p : runs) REQUIRE(same(p, all[i++]));
    REQUIRE(i == all.size());
}

TEST_CASE("PrimitiveRuns: given one long statement, then a primitive takes less than a byte") {
    PrimitiveRuns runs;
    for (std::uint32_t i = 0; i < 100'000; ++i) runs.push_back({1, Sides::both, i, 0});
    CHECK(runs.memory_bytes() < 100'000);
}
