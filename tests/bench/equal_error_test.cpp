// CPU time to equal error, for curves that follow known power laws.
#include "bench/convergence/equal_error.h"

#include <cmath>

#include "tests/catch.h"

using namespace etalon::convergence;

namespace {

/// Errors (1, 1/2, 1/4, ...)^slope at 1, 2, 4, ... seconds.
Curve curve(double slope, int points) {
    Curve c{"ours", "", "", ""};
    for (int i = 0; i < points; ++i) {
        const double seconds = std::exp2(i);
        c.points.push_back({seconds, seconds, 0, std::pow(seconds, -slope)});
    }
    return c;
}

}  // namespace

TEST_CASE("Time to an error lies on the line between two points in their logarithms") {
    for (const double slope : {0.5, 1.0, 1.7}) {
        INFO(slope);
        const TimeToError time = time_to_relmse(curve(slope, 5), std::pow(3.0, -slope));
        CHECK(time.cpu_seconds == Approx(3));
        CHECK_FALSE(time.extrapolated);
    }
    CHECK(time_to_relmse(curve(1, 5), 0.25).cpu_seconds == Approx(4));
    CHECK(time_to_relmse(curve(1, 5), 1.0 / 16).cpu_seconds == Approx(16));
    CHECK_FALSE(time_to_relmse(curve(1, 5), 1.0 / 16).extrapolated);
}

TEST_CASE("A floor is found though the first samples cost more than the last") {
    const auto fit_of = [](double floor) {
        std::vector<Point> points;
        for (const double n : {4, 8, 16, 32, 64}) points.push_back({n, 0.5 * n + 2, 1 / n + floor});
        return fit(points);
    };
    CHECK(fit_of(0.01)->floor == Approx(0.01));
    CHECK(fit_of(0)->floor == Approx(0).margin(1e-12));
    CHECK(fit_of(0)->slope < -1);
}

TEST_CASE("Beyond the ends of a curve its error falls as 1 / time, and that is said") {
    for (const double relmse : {4.0, 1.0 / 64}) {
        const TimeToError time = time_to_relmse(curve(1, 5), relmse);
        CHECK(time.cpu_seconds == Approx(1 / relmse));
        CHECK(time.extrapolated);
    }
    CHECK(time_to_relmse(curve(2, 5), 1.0 / 512).cpu_seconds == Approx(32));  // from 16 s, 1/256
}

TEST_CASE("A curve that rises again counts where it falls for the last time") {
    Curve c = curve(1, 3);
    c.points[1].relmse = 0.3;
    c.points[2].relmse = 0.5;
    c.points.push_back({8, 8, 0, 0.1});
    const TimeToError time = time_to_relmse(c, 0.4);
    CHECK(time.cpu_seconds > 4);
    CHECK(time.cpu_seconds < 8);
}

TEST_CASE("Preparation is part of the time, once") {
    Curve c = curve(1, 5);
    c.preparation = 1;
    CHECK(time_to_relmse(c, 0.25).cpu_seconds == Approx(5));
    CHECK(time_to_relmse(c, 1.0 / 32).cpu_seconds == Approx(33));
}

TEST_CASE("Ratios leave out what is extrapolated, unless there is nothing else") {
    const std::vector<ForeignCurve> foreign{
        {"slow", {{1, 8, 0, 0.5}, {2, 32, 0, 0.25}, {64, 4096, 0, 1.0 / 64}, {0, 9, 0, 0}}},
        {"far", {{64, 640, 0, 1.0 / 64}}}};
    const auto all = compare({curve(1, 5), Curve{"empty", "", "", ""}}, foreign);
    REQUIRE(all.size() == 2);
    CHECK(all[0].program == "slow");
    CHECK(all[0].curve == "ours");
    REQUIRE(all[0].points.size() == 3);
    CHECK(all[0].ratio == Approx(std::sqrt(4.0 * 8.0)));
    CHECK_FALSE(all[0].extrapolated);
    CHECK(all[0].points[2].ratio == Approx(64));
    CHECK(all[1].ratio == Approx(10));
    CHECK(all[1].extrapolated);
}
