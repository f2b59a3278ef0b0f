#include "core/color/cie_1931.h"

#include <iterator>

#include "core/color/cie_1931_table.h"

namespace etalon {
namespace {

constexpr int row_count = static_cast<int>(std::size(y_bar_table));
constexpr int beyond = 2;  // rows that are needed before the first and after the last one

static_assert((row_count - 1) * table_step + 1 == wavelength_count);

using Rows = std::array<Vec3, row_count + 2 * beyond>;

/// Sum of six rows, each times its weight in `weights`, over `divisor`.
Vec3 weighted(const Vec3* rows, const std::array<double, 6>& weights, double divisor) {
    Vec3 sum(0);
    for (int i = 0; i < 6; ++i) sum += weights[i] * rows[i];
    return sum / divisor;
}

/// The table with two rows more at either end, as the CIE extrapolates for this interpolation.
Rows extended_table() {
    Rows rows;
    for (int i = 0; i < row_count; ++i) {
        rows[i + beyond] = {x_bar_table[i], y_bar_table[i], z_bar_table[i]};
    }
    const Vec3* const first = &rows[beyond];
    const Vec3* const last = &rows[row_count + beyond - 6];
    rows[0] = weighted(first, {884, -1960, 3033, -2648, 1080, -180}, 209);
    rows[1] = weighted(first, {508, -540, 488, -367, 144, -24}, 209);
    rows[row_count + 2] = weighted(last, {-24, 144, -367, 488, -540, 508}, 209);
    rows[row_count + 3] = weighted(last, {-180, 1080, -2648, 3033, -1960, 884}, 209);
    return rows;
}

/// Interpolates at t in [0, 1] from the third of six rows to the fourth, by Sprague's polynomial of
/// the fifth degree, whose first and second derivatives have no steps (CIE 167, Recommended
/// Practice for Tabulating Spectral Data for Use in Colour Computations).
Vec3 sprague(const Vec3* rows, double t) {
    const Vec3 a1 = weighted(rows, {2, -16, 0, 16, -2, 0}, 24);
    const Vec3 a2 = weighted(rows, {-1, 16, -30, 16, -1, 0}, 24);
    const Vec3 a3 = weighted(rows, {-9, 39, -70, 66, -33, 7}, 24);
    const Vec3 a4 = weighted(rows, {13, -64, 126, -124, 61, -12}, 24);
    const Vec3 a5 = weighted(rows, {-5, 25, -50, 50, -25, 5}, 24);
    return rows[2] + t * (a1 + t * (a2 + t * (a3 + t * (a4 + t * a5))));
}

MatchingFunctions interpolated() {
    const Rows rows = extended_table();
    MatchingFunctions functions;
    for (int i = 0; i + 1 < wavelength_count; ++i) {
        functions[i] = sprague(&rows[i / table_step], i % table_step / double{table_step});
    }
    functions.back() = rows[row_count + beyond - 1];
    return functions;
}

}  // namespace

const MatchingFunctions& cie_1931() {
    static const MatchingFunctions functions = interpolated();
    return functions;
}

}  // namespace etalon
