#include "core/texture/packed_colors.h"

#include <algorithm>
#include <cmath>

namespace etalon {

PackedColor packed(const Color& color) {
    PackedColor word = 0;
    for (int k = 0; k < 3; ++k) {
        const auto& [shift, largest, one] = packed_channels[k];
        const float root = std::min(std::sqrt(color[k]) * one, static_cast<float>(largest));
        word |= static_cast<PackedColor>(static_cast<int>(root + 0.5F)) << shift;
    }
    return word;
}

}  // namespace etalon
