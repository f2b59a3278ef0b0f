#include "bench/plot/ticks.h"

#include <cmath>

#include "tests/catch.h"

using namespace etalon::plot;

TEST_CASE("Every range of a logarithmic axis has some ticks, in order, inside, and not too many") {
    for (const double decades : {0.31, 0.5, 1.0, 2.0, 3.0, 7.0, 20.0}) {
        for (const double low : {-9.3, -2.0, 0.0, 0.7, 4.1}) {
            INFO(low << " + " << decades);
            const std::vector<Tick> ticks = log_ticks(low, low + decades);
            CHECK(ticks.size() >= 2);
            CHECK(ticks.size() <= 12);
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                const double place = std::log10(ticks[i].value);
                CHECK((place >= low && place <= low + decades));
                if (i > 0) CHECK(ticks[i].value > ticks[i - 1].value);
            }
        }
    }
}

TEST_CASE("Ticks are written as people read them") {
    CHECK(power_of_ten(0) == "1");
    CHECK(power_of_ten(1) == "10");
    CHECK(power_of_ten(-2) == "10⁻²");
    CHECK(power_of_ten(17) == "10¹⁷");
    CHECK(power_of_ten(-120) == "10⁻¹²⁰");
    CHECK(log_ticks(-0.1, 0.1).front().text == "0.8");
    CHECK(log_ticks(-6, -2).front().text == "10⁻⁶");
    CHECK(log_ticks(-6, -2).back().text == "0.01");
}
