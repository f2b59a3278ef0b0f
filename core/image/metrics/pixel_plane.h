#pragma once

#include <algorithm>
#include <vector>

#include "core/parallel/parallel.h"

namespace etalon {

/// One number for each pixel, in rows from the top.
struct PixelPlane {
    int width = 0, height = 0;
    std::vector<double> values;

    PixelPlane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * h) {}

    double* row(int y) { return &values[static_cast<std::size_t>(y) * width]; }
    const double* row(int y) const { return &values[static_cast<std::size_t>(y) * width]; }
};

/// Calls body(y) for each row, possibly in parallel.
template <class Body>
void for_each_row(int height, const Body& body) {
    parallel_for(static_cast<std::size_t>(height), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) body(static_cast<int>(y));
    });
}

/// Returns the plane of value(i) for each pixel, numbered by rows.
template <class Value>
PixelPlane plane_of(int width, int height, const Value& value) {
    PixelPlane plane(width, height);
    for_each_row(height, [&](int y) {
        const std::size_t first = static_cast<std::size_t>(y) * width;
        for (std::size_t i = first; i < first + width; ++i) plane.values[i] = value(i);
    });
    return plane;
}

}  // namespace etalon
