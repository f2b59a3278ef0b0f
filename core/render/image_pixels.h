#pragma once

#include <vector>

#include "core/image/image.h"
#include "core/render/film.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Returns the means of a film's pixels, in the values that an EXR of the image has.
inline std::vector<Color> image_pixels(const Film& film, const RenderSettings& settings) {
    std::vector<Color> pixels = film.pixels();
    if (settings.decodes()) decode(pixels);
    return pixels;
}

}  // namespace etalon
