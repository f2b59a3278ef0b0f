#include "core/image/orientation.h"

#include <algorithm>
#include <utility>

namespace etalon {
namespace {

/// Order of the stored pixels: whether a row is a column of the image, and whether rows, and pixels
/// in a row, are counted from the other end.
struct Order {
    bool is_transposed, rows_reversed, row_reversed;
};

constexpr Order orders[] = {{false, false, false}, {false, false, true}, {false, true, true},
                            {false, true, false},  {true, false, false}, {true, true, false},
                            {true, true, true},    {true, false, true}};

template <class Pixels>
void reorder(Pixels& pixels, const Image& stored, const Order& order) {
    const Pixels from = pixels;
    const int w = stored.width, h = stored.height, channels = stored.channels;
    auto to = pixels.begin();
    const auto put = [&](int x, int y) {
        const int column = order.row_reversed ? w - 1 - x : x;
        const int row = order.rows_reversed ? h - 1 - y : y;
        const std::size_t first = (static_cast<std::size_t>(row) * w + column) * channels;
        to = std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(first), channels, to);
    };
    for (int i = 0; i < (order.is_transposed ? w : h); ++i) {
        for (int k = 0; k < (order.is_transposed ? h : w); ++k) {
            order.is_transposed ? put(i, k) : put(k, i);
        }
    }
}

}  // namespace

void put_upright(Image& image, int orientation) {
    if (orientation < 2 || orientation > 8) return;
    const Order& order = orders[orientation - 1];
    std::visit(
        [&](auto& pixels) {
            if (!pixels.empty()) reorder(pixels, image, order);
        },
        image.pixels);
    if (order.is_transposed) std::swap(image.width, image.height);
}

}  // namespace etalon
