#include "core/texture/packed_colors.h"

#include <algorithm>
#include <cmath>

namespace etalon {

PackedColor packed(const Color& color) {
    PackedColor word = 0;
    for (int k = 0; k < 3; ++k) {
        const auto& [shift, largest, one] = packed_channels[k];
        const float root = std::round(std::sqrt(color[k]) * one);
        word |= static_cast<PackedColor>(std::min(root, static_cast<float>(largest))) << shift;
    }
    return word;
}

}  // namespace etalon
