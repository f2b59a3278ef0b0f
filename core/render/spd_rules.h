#pragma once

#include "core/scene/render_settings.h"

namespace etalon {

/// Follows the rules of the Standard Procedural Databases (Haines 1987): one ray
/// through each pixel corner, a reflected one from all glass.
inline void apply_spd_rules(RenderSettings& settings) {
    settings.samples_per_pixel = 0;
    settings.filter = {};
    settings.pixel_rays = PixelRays::shared_corners;
    settings.whitted.mirror_all_glass = true;
}

}  // namespace etalon
