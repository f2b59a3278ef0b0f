#include "bench/speed/disagreement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/speed/oracle_check.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::speed;

namespace {

/// Two triangles, one behind the other along -z: the nearer one is number 0.
Scene two_layers() {
    Scene scene;
    scene.geometry.vertices = {{-1, -1, 0},  {1, -1, 0},  {0, 1, 0},
                               {-1, -1, -1}, {1, -1, -1}, {0, 1, -1}};
    scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    scene.geometry.add(Triangle{{3, 4, 5}}, 0);
    return scene;
}

/// Three that hit the nearer triangle and one that misses.
RaySet four_rays(bool occlusion) {
    RaySet set{"camera", occlusion, {}};
    for (const double x : {-0.1, 0.0, 0.1, 5.0}) set.rays.push_back({{x, 0, 2}, {0, 0, -1}});
    return set;
}

const std::vector<Answer> right{{2, 0}, {2, 0}, {2, 0}, missed};

/// Checks answers against the oracle, which has time for all rays.
OracleCheck check(const std::vector<Answer>& answers, bool occlusion) {
    hard::CaseSetup setup;
    setup.scene = two_layers();
    const Oracle oracle(setup.scene.geometry);
    const RaySet set = four_rays(occlusion);
    return OracleReferences(setup, oracle, set, scattered(set.rays.size()), 100)
        .check(answers, true);
}

}  // namespace

TEST_CASE("Equal answers do not differ") {
    const Disagreement d = compare(right, right, false);
    CHECK(d.rays == 4);
    CHECK(d.total() == 0);
}

TEST_CASE("Every planted disagreement is counted once, for what differs most") {
    const double next = std::nextafter(2.0, 3.0);
    CHECK(compare(std::vector<Answer>{missed, {2, 0}, {2, 0}, missed}, right, false).hit_or_miss ==
          1);
    CHECK(compare(std::vector<Answer>{{2, 0}, {2, 0}, {2, 0}, {7, 1}}, right, false).hit_or_miss ==
          1);
    const Disagreement d =
        compare(std::vector<Answer>{{3, 1}, {next, 0}, missed, {7, 1}}, right, false);
    CHECK(d.primitive == 1);
    CHECK(d.distance == 1);
    CHECK(d.hit_or_miss == 2);
    CHECK(d.total() == 4);
}

TEST_CASE("Of occlusion queries only hit or miss is compared") {
    const std::vector<Answer> reference{{0, 0}, {0, 0}, missed, missed};
    const std::vector<Answer> other{{5, 1}, missed, {0, 0}, missed};
    const Disagreement d = compare(other, reference, true);
    CHECK(d.hit_or_miss == 2);
    CHECK(d.total() == 2);
}

TEST_CASE("Zeros of either sign have other bits") {
    CHECK(compare(std::vector<Answer>{{-0.0, 0}}, std::vector<Answer>{{0.0, 0}}, false).distance ==
          1);
}

TEST_CASE("The oracle finds nothing wrong with right answers") {
    for (const bool occlusion : {false, true}) {
        const OracleCheck j = check(right, occlusion);
        CHECK(j.rays == 4);
        CHECK(j.undecidable == 0);
        CHECK(j.errors() == 0);
        CHECK(j.t_ulps == 0);
    }
}

TEST_CASE("The oracle counts each planted error as what it is") {
    const double off = 2 + 3 * 0x1p-22;  // ulp of a float at 2: 2^-22
    const OracleCheck j = check({{off, 0}, {3, 1}, missed, {7, 0}}, false);
    CHECK(j.false_hits == 1);
    CHECK(j.false_misses == 1);
    CHECK(j.wrong_primitives == 1);
    CHECK(j.wrong_roots == 1);
    CHECK(j.errors() == 4);
    CHECK(check({{2 + 0x1p-38, 0}, {2, 0}, {2, 0}, missed}, false).errors() == 0);
    CHECK(check({{off, 0}, {2, 0}, {2, 0}, missed}, false).t_ulps == 3);
}

TEST_CASE("The oracle counts false shadows and missing ones") {
    const OracleCheck j = check({{0, 0}, missed, missed, {0, 0}}, true);
    CHECK(j.false_hits == 1);
    CHECK(j.false_misses == 2);
    CHECK(j.wrong_primitives == 0);
}

TEST_CASE("Without time the oracle still judges one ray") {
    hard::CaseSetup setup;
    setup.scene = two_layers();
    const Oracle oracle(setup.scene.geometry);
    const RaySet set = four_rays(false);
    CHECK(OracleReferences(setup, oracle, set, {3, 1}, 0).check(right, true).rays == 1);
    CHECK(OracleReferences(setup, oracle, set, {}, 0).check(right, true).rays == 0);
}

TEST_CASE("Rays are in dispute where anyone differs in more than the bits of t") {
    const double next = std::nextafter(2.0, 3.0);
    const std::vector<std::vector<Answer>> answers{
        right, {{next, 0}, {3, 1}, {2, 0}, missed}, {{2, 0}, {2, 0}, {2, 0}, {7, 0}}};
    CHECK(disputed(answers, false) == std::vector<std::size_t>{1, 3});
    CHECK(disputed(answers, true) == std::vector<std::size_t>{3});
    CHECK(disputed({right}, false).empty());
}

TEST_CASE("A scattered order has every number once, and the first ones far apart") {
    std::vector<std::size_t> order = scattered(1000);
    CHECK(order[0] == 0);
    CHECK(order[1] == 512);
    CHECK(order[2] == 256);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < 1000; ++i) CHECK(order[i] == i);
    CHECK(order.size() == 1000);
}
