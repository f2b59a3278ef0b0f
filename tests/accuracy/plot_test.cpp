#include "bench/accuracy/report/plot.h"
#include "bench/accuracy/report/axes.h"
#include "bench/plot/labels.h"
#include "tests/accuracy/report_rows.h"
#include "tests/catch.h"
#include "tests/markup.h"

using namespace etalon::accuracy;
using etalon::plot::Label;
using etalon::plot::PlotArea;
using etalon::plot::Position;
using etalon::plot::Rectangle;
using etalon::test::is_well_formed;

namespace {

Point point(double cost, double error) {
    Point p;
    p.cost = cost;
    p.error = error;
    return p;
}

bool overlap(const Rectangle& a, const Rectangle& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

TEST_CASE("The efficient points are those that nothing beats in both cost and error") {
    std::vector<Point> points{point(1, 1000), point(2, 10), point(3, 10),  point(2.5, 2000),
                              point(4, 0),    point(4, 0),  point(9, 1e-9)};
    mark_efficient(points);
    std::vector<bool> efficient;
    for (const Point& p : points) efficient.push_back(p.efficient);
    CHECK(efficient == std::vector<bool>{true, true, false, false, true, true, false});
}

TEST_CASE("A point stands at the median of its costs and at the error of its worst case") {
    std::vector<Row> rows{row("A", "sphere", "float textbook", 100, 0, 1),
                          row("B", "sphere", "float textbook", 10, 500, 1),
                          row("C", "sphere", "float textbook", 1, 0, 4)};
    const Scatter scatter = scatter_of(rows, "sphere");
    REQUIRE(scatter.points.size() == 1);
    CHECK(scatter.unit == "float textbook");
    CHECK(scatter.cases == 3);
    CHECK(scatter.points[0].cost == 1);
    CHECK(scatter.points[0].error == 510);
    CHECK_THAT(scatter.points[0].worst_case, ContainsSubstring("B"));
}

TEST_CASE("Where no textbook gives the unit of cost, embree-builtin does, and else nanoseconds") {
    std::vector<Row> rows{row("A", "scene", "bvh", 0, 0, 0),
                          row("A", "scene", "embree-builtin", 0, 1, 0)};
    rows[0].nanoseconds = 30;
    rows[1].nanoseconds = 60;
    CHECK(scatter_of(rows, "scene").unit == "embree-builtin");
    CHECK(scatter_of(rows, "scene").points[0].cost == 0.5);
    rows.pop_back();
    CHECK(scatter_of(rows, "scene").unit.empty());
    CHECK(scatter_of(rows, "scene").points[0].cost == 30);
}

TEST_CASE("An error without bound has its place on the plot") {
    ErrorStats stats;
    stats.rays = 1;
    stats.float_ulps.add(std::numeric_limits<double>::infinity());
    CHECK(error_of(stats) == 0x1p24);
}

TEST_CASE("A plot is well-formed XML that names every tracer") {
    for (const char* shape : {"sphere", "scene"}) {
        const std::string svg = plot(sample_rows(), shape, {});
        CHECK(is_well_formed(svg));
        for (const Row& r : sample_rows()) {
            if (r.shape == shape) CHECK_THAT(svg, ContainsSubstring(">" + r.tracer + "</text>"));
        }
    }
    CHECK_THAT(plot(sample_rows(), "sphere", {}),
               ContainsSubstring("1e3 &lt;radii&gt; &amp; more"));
    CHECK(plot(sample_rows(), "cone", {}).empty());
}

TEST_CASE("There are ticks on both axes, however narrow the range, and the points are between") {
    for (const double dearest : {1.0, 1.3, 3.0, 1000.0}) {
        Scatter scatter{"float textbook", 1, {point(1, 0), point(dearest, 5)}};
        const PlotArea plot_area{360, 280, 34, 348, 30, 228};
        const Axes axes(scatter, plot_area);
        CHECK(axes.cost_ticks().size() >= 2);
        CHECK(axes.cost_ticks().size() <= 12);
        CHECK(axes.error_ticks().size() >= 2);
        for (const Point& p : scatter.points) {
            const Position at = axes.position(p.cost, p.error);
            CHECK((at.x > plot_area.left && at.x < plot_area.right));
            CHECK((at.y >= plot_area.top && at.y <= plot_area.bottom));
        }
    }
}

TEST_CASE("Given a crowd of marks, no label covers another or a mark") {
    std::vector<Label> labels;
    for (const double x : {500.0, 504.0, 509.0, 520.0, 560.0}) {
        labels.push_back({"a tracer", x < 505, {x, 300}});
    }
    const Rectangle page{0, 0, 600, 320};
    place_labels(labels, page, {});
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Rectangle r = extent(labels[i]);
        CHECK((r.left >= page.left && r.top >= page.top));
        CHECK((r.right <= page.right && r.bottom <= page.bottom));
        for (std::size_t k = 0; k < labels.size(); ++k) {
            const Position mark = labels[k].mark;
            CHECK_FALSE(
                (mark.x > r.left && mark.x < r.right && mark.y > r.top && mark.y < r.bottom));
            if (k != i) CHECK_FALSE(overlap(r, extent(labels[k])));
        }
    }
}

TEST_CASE("Given two marks below each other's label, no line to a label crosses another") {
    std::vector<Position> frontier;
    for (int i = 0; i <= 40; ++i) {
        frontier.push_back({119 + 0.45 * i, 120});
        frontier.push_back({137 + 1.8 * i, 126});
        frontier.push_back({209, 126 + 7.5 * i});
    }
    std::vector<Label> labels{{"float textbook", true, {119, 120}},
                              {"double textbook", true, {137, 126}},
                              {"float RTG7", false, {213, 121}}};
    place_labels(labels, {72, 94, 756, 436}, frontier);
    for (const Label& label : labels) {
        const Position end = leader_end(label);
        for (double s = 0; label.is_far && s < 1; s += 0.01) {
            const double x = label.mark.x + s * (end.x - label.mark.x);
            const double y = label.mark.y + s * (end.y - label.mark.y);
            for (const Label& other : labels) {
                if (&other != &label) CHECK_FALSE(overlap({x, y, x, y}, extent(other)));
            }
        }
    }
}
