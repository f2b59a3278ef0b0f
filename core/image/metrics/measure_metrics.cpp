#include "core/image/metrics/measure_metrics.h"

#include "core/image/metrics/flip.h"
#include "core/image/metrics/ssim.h"

namespace etalon {

Metrics measure(Pixels a, Pixels reference, const PixelPlane& flip_map) {
    Metrics m;
    m.mse = mse(a, reference);
    m.relmse = relmse(a, reference);
    m.mae = mae(a, reference);
    m.psnr = psnr(m.mse);
    m.ssim = ssim(a, reference, flip_map.width);
    m.flip = flip(flip_map);
    m.max_abs = max_abs(a, reference);
    m.different_pixels = different_pixels(a, reference);
    m.mean_a = mean(a);
    m.mean_b = mean(reference);
    return m;
}

}  // namespace etalon
