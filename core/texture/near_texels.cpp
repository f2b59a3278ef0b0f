#include "core/texture/near_texels.h"

#include <algorithm>
#include <cmath>

namespace etalon {
namespace {

/// Two texels of a row or column, with weights 1 - fraction and fraction; -1 is a black one.
struct Pair {
    int first, second;
    float fraction;
};

/// Wraps a coordinate to the range where indices fit an int: to one period of a repeating image, or
/// to so far outside that only the border, or black, is seen.
double in_range(double coordinate, Wrap wrap) {
    const double reduced = wrap == Wrap::repeat ? coordinate - std::floor(coordinate)
                                                : std::clamp(coordinate, -1.0, 2.0);
    return std::isfinite(reduced) ? reduced : 0.0;
}

int wrapped(int index, int count, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp(index, 0, count - 1);
    if (index >= 0 && index < count) return index;
    if (wrap == Wrap::black) return -1;
    return index < 0 ? index + count : index - count;
}

Pair pair_at(double coordinate, int count, Wrap wrap) {
    const double place = in_range(coordinate, wrap) * count - 0.5;
    const double below = std::floor(place);
    const int first = static_cast<int>(below);
    return {wrapped(first, count, wrap), wrapped(first + 1, count, wrap),
            static_cast<float>(place - below)};
}

}  // namespace

NearTexels near_texels(int width, int height, Wrap wrap, const Vec2& st) {
    const Pair s = pair_at(st.x, width, wrap), t = pair_at(st.y, height, wrap);
    NearTexels result{};
    std::size_t k = 0;
    for (const auto& [row, row_weight] :
         {std::pair(t.first, 1 - t.fraction), {t.second, t.fraction}}) {
        for (const auto& [column, weight] :
             {std::pair(s.first, 1 - s.fraction), {s.second, s.fraction}}) {
            if (row >= 0 && column >= 0) {
                const auto from_top = static_cast<std::size_t>(height - 1 - row);
                result.texels[k] = from_top * width + column;
                result.weights[k] = row_weight * weight;
            }
            ++k;
        }
    }
    return result;
}

}  // namespace etalon
