#include "core/render/filtered_errors.h"

#include <algorithm>

#include "core/color/srgb.h"
#include "core/parallel/parallel.h"
#include "core/render/filter_axis.h"

namespace etalon {
namespace {

/// One value for each pixel of a window, in rows.
struct Plane {
    Imath::Box2i window;
    std::vector<Vec3> values;

    explicit Plane(const Imath::Box2i& of)
        : window(of), values(static_cast<std::size_t>(width()) * height(), Vec3(0)) {}

    int width() const { return window.max.x - window.min.x + 1; }
    int height() const { return window.max.y - window.min.y + 1; }
    const Vec3& at(const Imath::V2i& p) const {
        const Imath::V2i offset = p - window.min;
        return values[static_cast<std::size_t>(offset.y) * width() + offset.x];
    }
};

/// Returns the contribution of a squared small error of a value to its relMSE, or to that of the
/// light for which it stands.
Vec3 relative_factor(const Vec3& value, bool decodes) {
    Vec3 factor;
    for (int k = 0; k < 3; ++k) {
        const double light = decodes ? srgb_decoded(value[k]) : value[k];
        const double slope = decodes ? srgb_slope(value[k], light) : 1;
        factor[k] = slope * slope / (light * light + 0.01);
    }
    return factor;
}

/// Convolves the values of pixels with `squares` along one axis, for the pixels of another window.
Plane spread(const Plane& from, const Imath::Box2i& window, const std::vector<double>& squares,
             int axis) {
    Plane result(window);
    const int reach = static_cast<int>(squares.size()) / 2;
    parallel_for(result.values.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Imath::V2i p = window.min + Imath::V2i(static_cast<int>(i) % result.width(),
                                                   static_cast<int>(i) / result.width());
            const int place = p[axis];
            const int last = std::min(place + reach, from.window.max[axis]);
            for (p[axis] = std::max(place - reach, from.window.min[axis]); p[axis] <= last;
                 ++p[axis]) {
                result.values[i] += squares[p[axis] - place + reach] * from.at(p);
            }
        }
    });
    return result;
}

}  // namespace

FilteredErrors filtered_errors(const Film& image, const std::vector<Vec3>& before,
                               const Imath::Box2i& samples, const RenderSettings& settings) {
    Plane own(image.window());
    double change = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        own.values[i] = relative_factor(image.mean(i), settings.decodes());
        const Vec3 difference = image.mean(i) - before[i];
        change += (difference * difference).dot(own.values[i]) / 3;
    }
    const Imath::Box2i rows({samples.min.x, image.window().min.y},
                            {samples.max.x, image.window().max.y});
    const Plane across = spread(own, rows, FilterAxis(settings.filter, 0).mean_squares(), 0);
    Plane both = spread(across, samples, FilterAxis(settings.filter, 1).mean_squares(), 1);
    const auto pixels = static_cast<double>(image.size());
    for (Vec3& factor : both.values) factor *= static_cast<double>(both.values.size()) / pixels;
    return {std::move(both.values), change / pixels};
}

}  // namespace etalon
