#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/numerics/vec.h"

namespace etalon {

enum class FilterKind : std::uint8_t { box, triangle, gaussian, mitchell, sinc };

/// Reconstruction filter. Each sample counts by a weight, a product of one factor for its
/// horizontal distance from a pixel's centre and one for the vertical. Both are 0 beyond the
/// radius.
struct PixelFilter {
    FilterKind kind = FilterKind::box;
    Vec2 radius{0.5, 0.5};  ///< in pixels, above 0 and at most max_filter_radius
    double alpha = 2;       ///< of a Gaussian: exp(-alpha d^2) minus its value at the radius
    double b = 1.0 / 3, c = 1.0 / 3;  ///< of Mitchell and Netravali (1988)
    double tau = 3;                   ///< of a sinc: cycles until Lanczos' window is 0

    /// Returns whether each sample counts only for the pixel in which it lies.
    bool is_pixel_box() const { return kind == FilterKind::box && radius == Vec2(0.5); }
};

/// A filter's name and default radius, which are pbrt-v3's.
struct FilterType {
    std::string_view name;
    FilterKind kind;
    double radius;
};

inline constexpr std::array filter_list{
    FilterType{"box", FilterKind::box, 0.5}, FilterType{"triangle", FilterKind::triangle, 2},
    FilterType{"gaussian", FilterKind::gaussian, 2},
    FilterType{"mitchell", FilterKind::mitchell, 2}, FilterType{"sinc", FilterKind::sinc, 4}};

/// Largest radius. Wider filters blur everything, and memory grows with the square of the radius.
inline constexpr double max_filter_radius = 64;

}  // namespace etalon
