#include "bench/convergence/measure_foreign.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/common/reference_image.h"
#include "bench/convergence/mean_difference.h"
#include "core/image/metrics/metrics.h"

namespace etalon::convergence {
namespace {

/// Returns why an image does not have these pixels; empty if its size is equal or unknown.
std::string check_size(const ForeignImage& image, const RenderSettings& settings) {
    const Imath::V2i& asked = settings.resolution;
    const auto is_other = [](int given, int expected) { return given != 0 && given != expected; };
    if (!is_other(image.size.x, asked.x) && !is_other(image.size.y, asked.y)) return {};
    return fmt::format("{}: error: {} x {} pixels; expected {} x {}", image.where, image.size.x,
                       image.size.y, asked.x, asked.y);
}

Result<Point> point_of(const ForeignImage& image, const ReferenceImage& reference,
                       const RenderSettings& settings) {
    if (std::string error = check_size(image, settings); !error.empty()) return {{}, error};
    Point point{image.samples, image.cpu_seconds, image.mse, image.relmse};
    if (!image.image.empty()) {
        const Result<std::vector<Color>> pixels = read_reference(image.image, settings);
        if (!pixels) return {{}, fmt::format("{}: error: {}", image.where, pixels.error)};
        point.mse = mse(pixels.value, reference.pixels);
        point.relmse = relmse(pixels.value, reference.pixels);
        point.mean_difference = mean_difference(mean(pixels.value), mean(reference.pixels));
    }
    point.mse_least = point.mse_most = point.mse;
    return {point, {}};
}

ForeignCurve& curve_of(const std::string& program, std::vector<ForeignCurve>& curves) {
    const auto found = std::ranges::find(curves, program, &ForeignCurve::program);
    if (found != curves.end()) return *found;
    return curves.emplace_back(ForeignCurve{program, {}});
}

}  // namespace

Result<std::vector<ForeignCurve>> measure_foreign(const std::vector<ForeignImage>& images,
                                                  const ReferenceImage& reference,
                                                  const RenderSettings& settings) {
    std::vector<ForeignCurve> curves;
    for (const ForeignImage& image : images) {
        const Result<Point> point = point_of(image, reference, settings);
        if (!point) return {{}, point.error};
        curve_of(image.program, curves).points.push_back(point.value);
    }
    for (ForeignCurve& curve : curves) {
        std::ranges::sort(curve.points, {}, &Point::cpu_seconds);
    }
    return {std::move(curves), {}};
}

}  // namespace etalon::convergence
