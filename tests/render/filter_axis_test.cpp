#include "core/render/filter_axis.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/catch.h"

using namespace etalon;

namespace {

FilterAxis axis(const PixelFilter& filter) {
    return {filter, 0};
}

PixelFilter usual(FilterKind kind) {
    for (const FilterType& type : filter_list) {
        if (type.kind == kind) return {kind, Vec2(type.radius)};
    }
    return {};
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("A filter's weights are those of its formula", "[film]") {
    CHECK(axis({FilterKind::box, {3, 1}})(2.5) == 1);
    CHECK(axis({FilterKind::triangle, {2, 1}})(0.75) == 1.25);
    CHECK(axis({FilterKind::triangle, {2, 1}})(-0.75) == 1.25);
    const FilterAxis gaussian = axis({FilterKind::gaussian, {1.5, 1}, 0.5});
    CHECK(gaussian(0) == Approx(1 - std::exp(-1.125)));
    CHECK(gaussian(1) == Approx(std::exp(-0.5) - std::exp(-1.125)));
    CHECK(gaussian(1.5) == 0);
    const FilterAxis mitchell = axis({FilterKind::mitchell, {2, 1}});
    CHECK(mitchell(0) == Approx(8.0 / 9));  // the published filter also has a radius of 2
    CHECK(mitchell(1) == Approx(1.0 / 18));
    CHECK(mitchell(1.5) == Approx(-5.0 / 144));
    CHECK(mitchell(2) == Approx(0).margin(1e-15));
    CHECK(axis({FilterKind::mitchell, {4, 1}})(3) == Approx(-5.0 / 144));
    CHECK(axis({FilterKind::mitchell, {2, 1}, 2, 0, 0.5})(0) == 1);  // Catmull-Rom
    const FilterAxis sinc = axis({FilterKind::sinc, {4, 1}, 2, 0, 0, 3});
    CHECK(sinc(0) == 1);
    CHECK(sinc(1) == Approx(0).margin(1e-15));
    const double pi = std::numbers::pi;
    CHECK(sinc(1.5) == Approx(std::sin(1.5 * pi) / (1.5 * pi) * std::sin(0.5 * pi) / (0.5 * pi)));
}

TEST_CASE("A filter has a radius of its own for each axis", "[film]") {
    const PixelFilter filter{FilterKind::triangle, {2, 3}};
    CHECK(FilterAxis(filter, 0)(0) == 2);
    CHECK(FilterAxis(filter, 1)(0) == 3);
}

TEST_CASE("A sample reaches the pixels whose centres are within the radius", "[film]") {
    const FilterAxis box = axis({FilterKind::box, {0.5, 0.5}});
    CHECK(box.first(7.25) == 7);
    CHECK(box.last(7.25) == 7);
    const FilterAxis two = axis({FilterKind::gaussian, {2, 2}});
    CHECK(two.first(7.25) == 5);
    CHECK(two.last(7.25) == 8);
    CHECK(two.first(7.5) == 5);
    CHECK(two.last(7.5) == 9);
}

TEST_CASE("The window of samples is larger by the radius, less half a pixel", "[film]") {
    const Imath::Box2i window({3, 5}, {9, 8});
    CHECK(sampled_window(window, {}) == window);
    CHECK(sampled_window(window, {FilterKind::gaussian, {2, 1.5}}) ==
          Imath::Box2i({1, 4}, {11, 9}));
    CHECK(sampled_window(window, {FilterKind::sinc, {4, 0.25}}) == Imath::Box2i({-1, 5}, {13, 8}));
}

TEST_CASE("Mean squares of weights are what samples taken anywhere leave of a variance", "[film]") {
    CHECK(axis({}).mean_squares() == std::vector<double>{0, 1, 0});
    const double triangle = sum_of(axis(usual(FilterKind::triangle)).mean_squares());
    CHECK(triangle == Approx(1.0 / 3).epsilon(1e-3));  // 2 (8/3) / 16
    const double gaussian = sum_of(axis(usual(FilterKind::gaussian)).mean_squares());
    CHECK(gaussian == Approx(1 / std::sqrt(std::numbers::pi)).epsilon(2e-3));
    const std::vector<double> squares = axis(usual(FilterKind::mitchell)).mean_squares();
    CHECK(squares.size() == 5);
    CHECK(squares[1] == Approx(squares[3]));
    CHECK(squares[0] == Approx(squares[4]));
    CHECK(squares[2] > squares[1]);
}
