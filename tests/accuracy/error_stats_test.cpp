#include "core/numerics/vec.h"
#include "tests/accuracy/report_rows.h"
#include "tests/catch.h"

using namespace etalon::accuracy;
using etalon::infinity;

namespace {

constexpr std::uint64_t ErrorStats::*counts[] = {
    &ErrorStats::rays,         &ErrorStats::undecidable, &ErrorStats::false_hits,
    &ErrorStats::false_misses, &ErrorStats::wrong_roots, &ErrorStats::wrong_primitives,
    &ErrorStats::leaks,        &ErrorStats::self_hits,   &ErrorStats::contradictions,
    &ErrorStats::deviations};
constexpr Distribution ErrorStats::*distributions[] = {
    &ErrorStats::float_ulps, &ErrorStats::double_ulps, &ErrorStats::conditioned,
    &ErrorStats::position, &ErrorStats::shift};
static_assert(sizeof(ErrorStats) == std::size(counts) * sizeof(std::uint64_t) +
                                        std::size(distributions) * sizeof(Distribution),
              "a member of ErrorStats is not in these lists");

}  // namespace

TEST_CASE("A quantile is right to within a sixteenth of an octave, and the maximum exact") {
    Distribution d;
    for (int i = 1; i <= 1000; ++i) d.add(1e-9 * i);
    CHECK(d.count() == 1000);
    CHECK(d.max() == 1e-9 * 1000);
    for (const double q : {0.001, 0.5, 0.99, 1.0}) {
        CHECK(d.quantile(q) >= 1e-6 * q * (1 - 1e-12));
        CHECK(d.quantile(q) <= 1e-6 * q * std::exp2(1.0 / 16) * (1 + 1e-12));
    }
}

TEST_CASE("Zeros count in a quantile, and nothing has quantile zero") {
    Distribution d;
    CHECK(d.quantile(0.5) == 0);
    for (const double value : {0.0, 0.0, 0.0, 8.0}) d.add(value);
    CHECK(d.quantile(0.75) == 0);
    CHECK(d.quantile(0.76) == 8);
}

TEST_CASE("A quantile is as good for values of any size") {
    Distribution d;
    for (const double value : {1e-310, 1e-300, 1e30, 1e300}) d.add(value);
    CHECK(d.quantile(0.5) == Approx(1e-300).epsilon(0.05));
    CHECK(d.quantile(0.75) == Approx(1e30).epsilon(0.05));
    CHECK(d.quantile(1) == 1e300);
    d.add(infinity);
    CHECK(d.quantile(0.8) == Approx(1e300).epsilon(0.05));
    CHECK(d.quantile(1) == infinity);
}

TEST_CASE("The sum of tallies is the sum of each of their counts") {
    ErrorStats a, b;
    for (std::size_t i = 0; i < std::size(counts); ++i) {
        a.*counts[i] = i + 1;
        b.*counts[i] = 100 * (i + 1);
    }
    a += b;
    for (std::size_t i = 0; i < std::size(counts); ++i) {
        CAPTURE(i);
        CHECK(a.*counts[i] == 101 * (i + 1));
    }
}

TEST_CASE("The distributions of a sum of tallies are of the values of both") {
    ErrorStats a, b;
    for (std::size_t i = 0; i < std::size(distributions); ++i) {
        const double value = std::exp2(static_cast<double>(i));
        for (const double part : {1, 2}) (a.*distributions[i]).add(part * value);
        (b.*distributions[i]).add(1000 * value);
    }
    a += b;
    for (std::size_t i = 0; i < std::size(distributions); ++i) {
        CAPTURE(i);
        const double value = std::exp2(static_cast<double>(i));
        const Distribution& sum = a.*distributions[i];
        CHECK(sum.count() == 3);
        CHECK(sum.max() == 1000 * value);
        CHECK(sum.quantile(0.6) == Approx(2 * value).epsilon(0.05));
    }
}

TEST_CASE("Every kind of error is an error, and a ray is none") {
    std::uint64_t errors = 0;
    for (const auto count : counts) {
        ErrorStats t;
        t.*count = 1;
        errors += t.errors();
    }
    CHECK(errors == std::size(counts) - 2);  // all but `rays` and `undecidable`
}
