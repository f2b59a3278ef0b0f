#include "core/light/piecewise_constant.h"

#include "core/sampling/sobol.h"
#include "tests/catch.h"
#include "tests/chi_square.h"

using namespace etalon;
using Catch::Matchers::WithinRel;

namespace {

/// Values of 16 x 8 cells: some dark, one much brighter than the others.
CellValues uneven_cells() {
    CellValues cells{16, 8, {}};
    for (int i = 0; i < 16 * 8; ++i) cells.values.push_back(i % 5 == 0 ? 0 : 1 + i % 7);
    cells.values[37] = 50;
    return cells;
}

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

}  // namespace

TEST_CASE("Places of a grid are chosen as often as their cell's value says", "[light]") {
    const CellValues cells = uneven_cells();
    const PiecewiseConstant2D grid(cells.width, cells.height, cells.values);
    CHECK_THAT(grid.sum(), WithinRel(sum_of(cells.values), 1e-12));
    Random random(11);
    constexpr int count = 100000;
    std::vector<double> numbers(cells.values.size()), expected;
    for (int i = 0; i < count; ++i) {
        const double u = random.uniform(), v = random.uniform();
        const auto [place, density] = grid.sample({u, v});
        REQUIRE(place.x >= 0);
        REQUIRE(place.x < 1);
        REQUIRE(grid.density(place) == density);
        const auto x = static_cast<std::size_t>(place.x * 16),
                   y = static_cast<std::size_t>(place.y * 8);
        ++numbers[y * 16 + x];
        CHECK_THAT(density, WithinRel(cells.values[y * 16 + x] * 16 * 8 / grid.sum(), 1e-12));
    }
    for (const double value : cells.values) expected.push_back(value / grid.sum() * count);
    CHECK(test::chi_square_probability(numbers, expected) > 1e-3);
}

TEST_CASE("Cells are joined as long as that costs little noise", "[light]") {
    CellValues even{16, 8, std::vector(16 * 8, 0.5)};
    const CellValues joined = joined_cells(even, 8, 1.05);
    CHECK(joined.width == 4);
    CHECK(joined.height == 2);
    CHECK(joined.values == std::vector(8, 8.0));

    CHECK(joined_cells(even, 1000, 1.05).values == even.values);
    CHECK(joined_cells(uneven_cells(), 8, 1.05).values == uneven_cells().values);
    const CellValues one = joined_cells(uneven_cells(), 1, 100);
    CHECK(one.values == std::vector{sum_of(uneven_cells().values)});

    // Values of 1 and 3 have a mean square of 5, the square of their mean is 4.
    CellValues two{2, 1, {1, 3}};
    CHECK(joined_cells(two, 1, 1.24).width == 2);
    CHECK(joined_cells(two, 1, 1.26).width == 1);
}
