#include "tests/accuracy/report_rows.h"
#include "tests/catch.h"

using namespace etalon::accuracy;

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

TEST_CASE("Values beyond the buckets' range are kept at its ends") {
    Distribution d;
    for (const double value : {1e-300, 1e300}) d.add(value);
    CHECK(d.quantile(0.5) <= 1e-19);
    CHECK(d.quantile(1) >= 1e19);
    CHECK(d.max() == 1e300);
}

TEST_CASE("The sum of tallies is the tally of all rays") {
    Tally sum;
    for (const Row& r : sample_rows()) sum += r.tally;
    std::uint64_t rays = 0, errors = 0, ulps = 0;
    double worst = 0;
    for (const Row& r : sample_rows()) {
        rays += r.tally.rays;
        errors += r.tally.errors();
        ulps += r.tally.float_ulps.count();
        worst = std::max(worst, r.tally.float_ulps.max());
    }
    CHECK(sum.rays == rays);
    CHECK(sum.errors() == errors);
    CHECK(sum.float_ulps.count() == ulps);
    CHECK(sum.float_ulps.max() == worst);
}
