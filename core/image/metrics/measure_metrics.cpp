#include "core/image/metrics/measure_metrics.h"

#include "core/image/image.h"
#include "core/image/metrics/flip.h"
#include "core/image/metrics/ssim.h"

namespace etalon {
namespace {

std::vector<Color> decoded(Pixels display_values) {
    std::vector<Color> light(display_values.begin(), display_values.end());
    decode(light);
    return light;
}

/// Measures what is seen of two images of light.
MeasuredMetrics measure_light(Pixels a, Pixels reference, int width) {
    MeasuredMetrics m{{}, flip_map(a, reference, width)};
    m.metrics.flip = flip(m.flip_map);
    m.metrics.ssim = ssim(a, reference, width);
    return m;
}

}  // namespace

MeasuredMetrics measure(Pixels a, Pixels reference, int width, bool display_values) {
    MeasuredMetrics result = display_values ? measure_light(decoded(a), decoded(reference), width)
                                            : measure_light(a, reference, width);
    Metrics& m = result.metrics;
    m.mse = mse(a, reference);
    m.relmse = relmse(a, reference);
    m.mae = mae(a, reference);
    m.psnr = psnr(m.mse);
    m.max_abs = max_abs(a, reference);
    m.different_pixels = different_pixels(a, reference);
    m.mean_a = mean(a);
    m.mean_b = mean(reference);
    return result;
}

}  // namespace etalon
