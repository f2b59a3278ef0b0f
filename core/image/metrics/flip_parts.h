// The three steps of FLIP. Images are three planes each: Y, Cx, Cz.
#pragma once

#include <array>

#include "core/image/metrics/pixel_plane.h"
#include "core/numerics/vec.h"

namespace etalon {

inline constexpr double flip_pixels_per_degree = 67;

using YCxCz = std::array<PixelPlane, 3>;

/// What an eye at that distance can tell apart of an image: each channel through its contrast
/// sensitivity, then back among the colours there are. Hunt-adjusted L*a*b*, by rows.
std::vector<Vec3> seen_colors(const YCxCz& image);

/// The difference of two such colours, in [0, 1].
double color_difference(const Vec3& a, const Vec3& b);

/// How strong an edge and how strong a point each pixel of an image is, in [0, 1].
struct Features {
    PixelPlane edges, points;
};

/// From the luminance Y alone.
Features find_features(const PixelPlane& luminance);

/// The difference of features, in [0, 1], which raises that of colours.
double feature_difference(const Features& a, const Features& b, std::size_t pixel);

}  // namespace etalon
