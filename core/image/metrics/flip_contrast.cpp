// FLIP's colour pipeline, section 4.1 of the paper.
#include "core/image/metrics/convolve.h"
#include "core/image/metrics/flip_colors.h"
#include "core/image/metrics/flip_parts.h"

namespace etalon {
namespace {

constexpr double pi_squared = M_PI * M_PI;

/// A term of a contrast sensitivity function: a * sqrt(pi / b) * exp(-(pi d)^2 / b), with the
/// distance d in degrees. Table 1 of the paper.
struct Gaussian {
    double a, b;
};
constexpr Gaussian achromatic{1, 0.0047}, red_green{1, 0.0053};
constexpr Gaussian blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};

/// Radius of all the filters: three standard deviations of the widest.
int spatial_radius() {
    const double deviation = std::sqrt(blue_yellow[0].b / (2 * pi_squared));
    return static_cast<int>(std::ceil(3 * deviation * flip_pixels_per_degree));
}

/// One axis of the two-dimensional term, whose factor therefore enters as its square root.
Filter axis_of(const Gaussian& g) {
    return filter_of(spatial_radius(), [&](int x) {
        const double degrees = x / flip_pixels_per_degree;
        return std::sqrt(g.a * std::sqrt(M_PI / g.b)) *
               std::exp(-pi_squared * degrees * degrees / g.b);
    });
}

PixelPlane filtered(const PixelPlane& plane, const Gaussian& g) {
    const Filter axis = normalized(axis_of(g));
    return convolve(plane, axis, axis);
}

/// Returns the share of the first of two terms in the sum of all their weights in two dimensions.
double share_of_first(const Gaussian (&terms)[2]) {
    const auto weight = [](const Gaussian& g) {
        double sum = 0;
        for (const double w : axis_of(g)) sum += w;
        return sum * sum;
    };
    return weight(terms[0]) / (weight(terms[0]) + weight(terms[1]));
}

}  // namespace

std::vector<Vec3> seen_colors(const YCxCz& image) {
    const PixelPlane y = filtered(image[0], achromatic), cx = filtered(image[1], red_green);
    const PixelPlane cz[] = {filtered(image[2], blue_yellow[0]),
                             filtered(image[2], blue_yellow[1])};
    const double share = share_of_first(blue_yellow);
    std::vector<Vec3> seen(y.values.size());
    for_each_row(y.height, [&](int row) {
        const std::size_t first = static_cast<std::size_t>(row) * y.width;
        for (std::size_t i = first; i < first + y.width; ++i) {
            const double z = share * cz[0].values[i] + (1 - share) * cz[1].values[i];
            const Vec3 rgb = linear_of_ycxcz({y.values[i], cx.values[i], z});
            const auto clamped = [](double value) { return std::clamp(value, 0.0, 1.0); };
            seen[i] = hunt_lab_of_linear({clamped(rgb.x), clamped(rgb.y), clamped(rgb.z)});
        }
    });
    return seen;
}

double color_difference(const Vec3& a, const Vec3& b) {
    // Equations 4 to 6: large differences, above `knee` of the largest there is, are compressed
    // into the rest of [0, 1] above `knee_to`.
    constexpr double exponent = 0.7, knee = 0.4, knee_to = 0.95;
    static const double largest =
        std::pow(hyab(hunt_lab_of_linear({0, 1, 0}), hunt_lab_of_linear({0, 0, 1})), exponent);
    const double part = std::pow(hyab(a, b), exponent) / largest;
    return part < knee ? part * knee_to / knee
                       : knee_to + (part - knee) / (1 - knee) * (1 - knee_to);
}

}  // namespace etalon
