#pragma once

#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// Weights of an odd number of neighbours, the pixel itself in the middle.
using Filter = std::vector<double>;

/// Returns the weights function(-radius), ..., function(radius).
template <class Function>
Filter filter_of(int radius, const Function& function) {
    Filter filter;
    for (int x = -radius; x <= radius; ++x) filter.push_back(function(x));
    return filter;
}

/// Returns the filter with its weights scaled to sum to 1.
Filter normalized(Filter filter);

/// Convolves the rows with `along_x` and the result along the columns with `along_y`. Outside, the
/// image is continued by its nearest pixel.
PixelPlane convolve(const PixelPlane& plane, const Filter& along_x, const Filter& along_y);

PixelPlane convolve_x(const PixelPlane& plane, const Filter& filter);
PixelPlane convolve_y(const PixelPlane& plane, const Filter& filter);

}  // namespace etalon
