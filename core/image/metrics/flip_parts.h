// The three steps of FLIP. Images have three planes: Y, Cx, Cz.
#pragma once

#include <array>

#include "core/image/metrics/pixel_plane.h"
#include "core/numerics/vec.h"

namespace etalon {

inline constexpr double flip_pixels_per_degree = 67;

using YCxCz = std::array<PixelPlane, 3>;

/// Returns the colours that an eye at that distance can distinguish: each channel is filtered by
/// its contrast sensitivity, then colours are clamped to the gamut. In Hunt-adjusted L*a*b*, by
/// rows.
std::vector<Vec3> seen_colors(const YCxCz& image);

/// Returns the difference of two such colours, in [0, 1].
double color_difference(const Vec3& a, const Vec3& b);

/// Strengths of edges and of points at each pixel of an image, in [0, 1].
struct Features {
    PixelPlane edges, points;
};

/// Finds the features from the luminance Y alone.
Features find_features(const PixelPlane& luminance);

/// Returns the difference of features, in [0, 1], which increases that of colours.
double feature_difference(const Features& a, const Features& b, std::size_t pixel);

}  // namespace etalon
