#include "core/render/filter_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etalon {
namespace {

double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return std::abs(angle) < 1e-8 ? 1.0 : std::sin(angle) / angle;
}

double cubic(const double (&c)[4], double x) {
    return ((c[3] * x + c[2]) * x + c[1]) * x + c[0];
}

}  // namespace

FilterAxis::FilterAxis(const PixelFilter& f, int axis)
    : kind_(f.kind),
      radius_(f.radius[axis]),
      alpha_(f.alpha),
      at_radius_(std::exp(-f.alpha * radius_ * radius_)),
      tau_(f.tau),
      near_{(6 - 2 * f.b) / 6, 0, (-18 + 12 * f.b + 6 * f.c) / 6, (12 - 9 * f.b - 6 * f.c) / 6},
      far_{(8 * f.b + 24 * f.c) / 6, (-12 * f.b - 48 * f.c) / 6, (6 * f.b + 30 * f.c) / 6,
           (-f.b - 6 * f.c) / 6} {}

double FilterAxis::operator()(double distance) const {
    const double d = std::abs(distance);
    switch (kind_) {
        case FilterKind::box:
            return 1;
        case FilterKind::triangle:
            return std::max(0.0, radius_ - d);
        case FilterKind::gaussian:
            return std::max(0.0, std::exp(-alpha_ * d * d) - at_radius_);
        case FilterKind::mitchell: {
            const double x = 2 * d / radius_;
            return cubic(x > 1 ? far_ : near_, x);
        }
        case FilterKind::sinc:
            return sinc(d) * sinc(d / tau_);
    }
    return 0;
}

std::vector<double> FilterAxis::mean_squares() const {
    constexpr int steps = 64;
    const int reach = last(1);
    std::vector<double> squares(2 * reach + 1, 0.0);
    double sum = 0;
    for (int step = 0; step < steps; ++step) {
        const double place = (step + 0.5) / steps;
        for (int pixel = first(place); pixel <= last(place); ++pixel) {
            const double weight = (*this)(place - 0.5 - pixel);
            squares[reach + pixel] += weight * weight / steps;
            sum += weight / steps;
        }
    }
    if (sum == 0) return squares;
    for (double& square : squares) square /= sum * sum;
    return squares;
}

Imath::Box2i sampled_window(const Imath::Box2i& window, const PixelFilter& filter) {
    Imath::Box2i result;
    for (int k = 0; k < 2; ++k) {
        const double beyond = filter.radius[k] - 0.5;
        result.min[k] = static_cast<int>(std::floor(window.min[k] - beyond));
        result.max[k] = static_cast<int>(std::ceil(window.max[k] + 1 + beyond)) - 1;
    }
    return result;
}

}  // namespace etalon
