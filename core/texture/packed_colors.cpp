#include "core/texture/packed_colors.h"

#include <algorithm>
#include <cmath>

namespace etalon {

PackedColor packed(const Color& color) {
    constexpr float most = (1 << packed_bits) - 1;
    const auto steps = [](float x, std::size_t unit) { return std::round(x / packed_units[unit]); };
    const float largest = std::max({color.x, color.y, color.z});
    std::size_t unit = 0;
    while (unit + 1 < packed_units.size() && steps(largest, unit) > most) ++unit;
    auto word = static_cast<PackedColor>(unit << (3 * packed_bits));
    for (int k = 0; k < 3; ++k) {
        const float step = std::clamp(steps(color[k], unit), 0.0F, most);
        word |= static_cast<PackedColor>(step) << (k * packed_bits);
    }
    return word;
}

}  // namespace etalon
