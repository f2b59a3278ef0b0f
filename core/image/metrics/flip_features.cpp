// FLIP's feature pipeline, section 4.2 of the paper.
#include "core/image/metrics/convolve.h"
#include "core/image/metrics/flip_parts.h"

namespace etalon {
namespace {

/// Scales the positive weights to sum to 1 and the negative ones to -1.
Filter balanced(Filter filter) {
    double positive = 0, negative = 0;
    for (const double w : filter) (w > 0 ? positive : negative) += std::abs(w);
    for (double& w : filter) w /= w > 0 ? positive : negative;
    return filter;
}

/// A Gaussian as wide as the finest detail that is seen, 0.082 degrees, and its derivatives.
struct DetailFilters {
    Filter smooth, edge, point;
};

DetailFilters detail_filters() {
    const double deviation = 0.5 * 0.082 * flip_pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const double variance = deviation * deviation;
    const auto gaussian = [&](int x) { return std::exp(-x * x / (2 * variance)); };
    return {
        normalized(filter_of(radius, gaussian)),
        balanced(filter_of(radius, [&](int x) { return -x * gaussian(x); })),
        balanced(filter_of(radius, [&](int x) { return (x * x / variance - 1) * gaussian(x); }))};
}

/// Returns the length of the vector of two filters' results at each pixel.
PixelPlane lengths(const PixelPlane& x, const PixelPlane& y) {
    return plane_of(x.width, x.height, [&](std::size_t i) {
        return std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    });
}

}  // namespace

Features find_features(const PixelPlane& luminance) {
    static const DetailFilters filters = detail_filters();
    const PixelPlane unit = plane_of(luminance.width, luminance.height, [&](std::size_t i) {
        return (luminance.values[i] + 16) / 116;
    });
    const PixelPlane smooth = convolve_x(unit, filters.smooth);
    return {
        lengths(convolve(unit, filters.edge, filters.smooth), convolve_y(smooth, filters.edge)),
        lengths(convolve(unit, filters.point, filters.smooth), convolve_y(smooth, filters.point))};
}

double feature_difference(const Features& a, const Features& b, std::size_t i) {
    const double edges = std::abs(a.edges.values[i] - b.edges.values[i]);
    const double points = std::abs(a.points.values[i] - b.points.values[i]);
    return std::sqrt(std::max(edges, points) / std::sqrt(2.0));
}

}  // namespace etalon
