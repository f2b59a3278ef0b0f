#include "core/texture/zero_texels.h"

#include "core/texture/near_texels.h"

namespace etalon {

ZeroTexels::ZeroTexels(int width, int height, Wrap wrap)
    : width_(width),
      height_(height),
      wrap_(wrap),
      words_((static_cast<std::size_t>(width) * height + 63) / 64) {}

bool ZeroTexels::is_zero(const Vec2& st) const {
    const NearTexels near = near_texels(width_, height_, wrap_, st);
    for (std::size_t k = 0; k < near.texels.size(); ++k) {
        const std::size_t texel = near.texels[k];
        const bool is_set = (words_[texel / 64] >> texel % 64 & 1) != 0;
        if (is_set && near.weights[k] != 0) return false;
    }
    return true;
}

}  // namespace etalon
