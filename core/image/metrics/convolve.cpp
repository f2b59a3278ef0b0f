#include "core/image/metrics/convolve.h"

#include <numeric>

namespace etalon {
namespace {

int radius(const Filter& filter) {
    return static_cast<int>(filter.size() / 2);
}

/// Computes out[x] = the sum of filter[k] * rows[k][x], for `count` of them.
void weigh(const Filter& filter, const std::vector<const double*>& rows, double* out, int count) {
    constexpr int block = 16;  // sums that fit into registers
    int x = 0;
    for (; x + block <= count; x += block) {
        double sums[block] = {};
        for (std::size_t k = 0; k < filter.size(); ++k) {
            for (int i = 0; i < block; ++i) sums[i] += filter[k] * rows[k][x + i];
        }
        std::copy_n(sums, block, out + x);
    }
    for (; x < count; ++x) {
        double sum = 0;
        for (std::size_t k = 0; k < filter.size(); ++k) sum += filter[k] * rows[k][x];
        out[x] = sum;
    }
}

}  // namespace

Filter normalized(Filter filter) {
    const double sum = std::accumulate(filter.begin(), filter.end(), 0.0);
    for (double& weight : filter) weight /= sum;
    return filter;
}

PixelPlane convolve_x(const PixelPlane& plane, const Filter& filter) {
    PixelPlane result(plane.width, plane.height);
    for_each_row(plane.height, [&](int y) {
        const double *first = plane.row(y), *last = first + plane.width - 1;
        std::vector<double> wide(radius(filter), *first);
        wide.insert(wide.end(), first, last + 1);
        wide.insert(wide.end(), radius(filter), *last);
        std::vector<const double*> shifted;
        for (std::size_t k = 0; k < filter.size(); ++k) shifted.push_back(&wide[k]);
        weigh(filter, shifted, result.row(y), plane.width);
    });
    return result;
}

PixelPlane convolve_y(const PixelPlane& plane, const Filter& filter) {
    PixelPlane result(plane.width, plane.height);
    for_each_row(plane.height, [&](int y) {
        std::vector<const double*> rows;
        for (int k = y - radius(filter); k <= y + radius(filter); ++k) {
            rows.push_back(plane.row(std::clamp(k, 0, plane.height - 1)));
        }
        weigh(filter, rows, result.row(y), plane.width);
    });
    return result;
}

PixelPlane convolve(const PixelPlane& plane, const Filter& along_x, const Filter& along_y) {
    return convolve_y(convolve_x(plane, along_x), along_y);
}

}  // namespace etalon
