#include "bench/plot/line_chart.h"

#include <cstdio>
#include <limits>

#include "tests/catch.h"
#include "tests/markup.h"

using namespace etalon::plot;
using etalon::test::count;
using etalon::test::is_well_formed;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

LineChart chart(std::vector<Series> series) {
    return {"error <against> time", "seconds", "error", std::move(series)};
}

}  // namespace

TEST_CASE("A chart of curves names every curve and says in words what it shows") {
    const std::string svg = line_chart(
        chart({{"a & b", {{1, 1}, {10, 0.1}, {100, 0.01}}}, {"c", {{1, 2}, {10, 1.5}}}}));
    CHECK(is_well_formed(svg));
    CHECK_THAT(svg, ContainsSubstring("<title>error &lt;against&gt; time</title>"));
    CHECK_THAT(svg, ContainsSubstring("a &amp; b: 1 at 1 to 0.01 at 100."));
    CHECK_THAT(svg, ContainsSubstring(">a &amp; b</text>") && ContainsSubstring(">c</text>"));
    CHECK(count(svg, "<polyline ") == 2);
    CHECK(count(svg, "<circle ") == 5);
    CHECK_THAT(svg, !ContainsSubstring("nan") && !ContainsSubstring("inf"));
}

TEST_CASE("A curve falls to the right where its values do, whatever they are") {
    for (const double scale : {1e-200, 1e-3, 1.0, 1e200}) {
        const std::string svg =
            line_chart(chart({{"a", {{scale, scale}, {2 * scale, scale / 2}}}}));
        double x[2], y[2];
        const std::size_t at = svg.find("polyline points=\"");
        REQUIRE(at != std::string::npos);
        REQUIRE(std::sscanf(svg.c_str() + at, "polyline points=\"%lf,%lf %lf,%lf\"", x, y, x + 1,
                            y + 1) == 4);
        CHECK(x[1] > x[0] + 100);
        CHECK(y[1] > y[0] + 100);
    }
}

TEST_CASE("What has no logarithm has no place on a chart, and a chart of nothing is empty") {
    const std::string svg = line_chart(
        chart({{"a", {{0, 1}, {1, 0}, {2, -1}, {3, infinity}, {4, 1}, {5, 2}}}, {"b", {}}}));
    CHECK(count(svg, "<circle ") == 2);
    CHECK_THAT(svg, !ContainsSubstring(">b</text>"));
    CHECK(line_chart(chart({})).empty());
    CHECK(line_chart(chart({{"a", {{0, 0}}}})).empty());
}

TEST_CASE("A single sample and a flat curve can be drawn, and a band where there is one") {
    CHECK(is_well_formed(line_chart(chart({{"a", {{1, 1}}}}))));
    const std::string svg = line_chart(chart({{"a", {{1, 1, 0.5, 2}, {2, 1, 0.5, 2}}}}));
    CHECK(count(svg, "<polygon ") == 1);
    CHECK_THAT(svg, !ContainsSubstring("nan"));
}
