#include "core/light/piecewise_constant.h"

namespace etalon {
namespace {

/// Returns the cell of a row at a share in [0, 1) of the row's sum, and how far the share is within
/// that cell.
std::pair<std::size_t, double> find_in(const SearchGuide& guide, std::size_t row,
                                       std::span<const double> sums, double share) {
    auto i = std::min(guide.first_above(row, sums, share), sums.size() - 1);
    while (i > 0 && sums[i] == sums[i - 1]) --i;  // a cell of density 0 at the end
    const double before = i == 0 ? 0 : sums[i - 1], size = sums[i] - before;
    const double value = share * sums.back();
    return {i, size > 0 ? std::clamp((value - before) / size, 0.0, 1 - 0x1p-53) : 0.5};
}

/// Returns the grid with half the sides, whose cells are sums of four.
CellValues joined_by_fours(const CellValues& from) {
    CellValues to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    to.values.resize(static_cast<std::size_t>(to.width) * to.height);
    for (int y = 0; y < from.height; ++y) {
        const double* const row = &from.values[static_cast<std::size_t>(y) * from.width];
        const int half = std::min(y / 2, to.height - 1);
        double* const sums = &to.values[static_cast<std::size_t>(half) * to.width];
        for (int x = 0; x < from.width; ++x) sums[std::min(x / 2, to.width - 1)] += row[x];
    }
    return to;
}

/// Returns the mean squared value over density if cells are sampled in proportion to their sums;
/// `squares` are the sums of the squares of `count` values in each.
double second_moment(const CellValues& sums, const CellValues& squares, double count) {
    double moment = 0, total = 0;
    for (std::size_t i = 0; i < sums.values.size(); ++i) {
        total += sums.values[i];
        if (sums.values[i] > 0) moment += count * squares.values[i] / sums.values[i];
    }
    return moment / total;
}

}  // namespace

PiecewiseConstant2D::PiecewiseConstant2D(int width, int height, std::vector<double> values)
    : width_(width), height_(height), cells_(std::move(values)) {
    sums_.reserve(cells_.size());
    double total = 0;
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) {
        double sum = 0;
        for (int x = 0; x < width; ++x) sums_.push_back(sum += cells_[row * width + x]);
        row_sums_.push_back(total += sum);
        guide_.add(sums_of_row(row));
    }
    row_guide_.add(row_sums_);
    const double cell_area = 1.0 / (static_cast<double>(width) * height);
    for (double& cell : cells_) cell /= total * cell_area;
}

std::span<const double> PiecewiseConstant2D::sums_of_row(std::size_t row) const {
    const auto width = static_cast<std::size_t>(width_);
    return {&sums_[row * width], width};
}

PiecewiseConstant2D::Sample PiecewiseConstant2D::sample(const Vec2& uv) const {
    const auto [row, v] = find_in(row_guide_, 0, row_sums_, uv.y);
    const auto [column, u] = find_in(guide_, row, sums_of_row(row), uv.x);
    const Vec2 place((static_cast<double>(column) + u) / width_,
                     (static_cast<double>(row) + v) / height_);
    return {place, cells_[row * static_cast<std::size_t>(width_) + column]};
}

double PiecewiseConstant2D::density(const Vec2& place) const {
    const int x = std::min(static_cast<int>(place.x * width_), width_ - 1);
    const int y = std::min(static_cast<int>(place.y * height_), height_ - 1);
    return cells_[static_cast<std::size_t>(y) * width_ + x];
}

CellValues joined_cells(CellValues cells, std::size_t enough, double most_moment) {
    CellValues squares = cells;
    for (double& value : squares.values) value *= value;
    double count = 1;
    while (cells.values.size() > enough) {
        CellValues next = joined_by_fours(cells);
        squares = joined_by_fours(squares);
        count *= static_cast<double>(cells.values.size()) / static_cast<double>(next.values.size());
        if (!(second_moment(next, squares, count) < most_moment)) break;
        cells = std::move(next);
    }
    return cells;
}

}  // namespace etalon
