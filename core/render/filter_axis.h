#pragma once

#include <vector>

#include "core/scene/pixel_filter.h"

namespace etalon {

/// A pixel filter along one axis of the image.
class FilterAxis {
  public:
    /// `axis`: 0 is horizontal, 1 vertical.
    FilterAxis(const PixelFilter& filter, int axis);

    double radius() const { return radius_; }

    /// Returns the weight of a sample at this distance from a pixel's centre, at most the radius.
    double operator()(double distance) const;

    /// Returns the first or last pixel whose centre is within the radius of a sample at `place`.
    int first(double place) const { return static_cast<int>(std::ceil(place - 0.5 - radius_)); }
    int last(double place) const { return static_cast<int>(std::floor(place - 0.5 + radius_)); }

    /// Returns the variance that samples of a pixel contribute to the pixels around it, relative to
    /// their own: for offsets from -n to n, the mean square of the weight over the pixel, where all
    /// weights around a pixel sum to 1. The sum over both axes is below 1 for filters that blur.
    std::vector<double> mean_squares() const;

  private:
    FilterKind kind_;
    double radius_, alpha_, at_radius_, tau_;
    double near_[4],
        far_[4];  ///< Mitchell's cubics, by increasing powers, within half the radius and beyond
};

/// Returns the pixels whose samples affect the pixels of `window`, as in pbrt-v3. Both inclusive.
Imath::Box2i sampled_window(const Imath::Box2i& window, const PixelFilter& filter);

}  // namespace etalon
