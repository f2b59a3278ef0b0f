#pragma once

#include "core/texture/kept_texels.h"
#include "core/texture/power_of_two.h"

namespace etalon {

/// Returns the texels of `image`, which must outlive them, as a texture uses them before they are
/// scaled. As in pbrt-v3 the luminance is that of the stored values, and decoded afterwards.
TexelRows shown_rows(const Image& image, Shown what, bool decode_srgb);

}  // namespace etalon
