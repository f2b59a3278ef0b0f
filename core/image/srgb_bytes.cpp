#include "core/image/srgb_bytes.h"

#include <cmath>

#include "core/color/srgb.h"

namespace etalon {
namespace {

int byte_of(double linear) {
    return static_cast<int>(255 * srgb_encoded(linear) + 0.5);
}

/// Returns the least value of a byte: the inverse of the curve, corrected for roundings.
double least_of(int byte) {
    double x = srgb_decoded((byte - 0.5) / 255);
    while (byte_of(x) >= byte) x = std::nextafter(x, 0.0);
    while (byte_of(x) < byte) x = std::nextafter(x, 1.0);
    return x;
}

}  // namespace

SrgbBytes::SrgbBytes() {
    least_.front() = 0;
    least_.back() = infinity;
    for (int byte = 1; byte < 256; ++byte) least_[byte] = least_of(byte);
    std::uint8_t byte = 0;
    for (std::uint64_t i = 0; i <= last; ++i) {
        const auto start = std::bit_cast<double>((i + origin) << shift);
        while (least_[byte + 1] <= start) ++byte;
        first_bytes_[i] = byte;
    }
}

}  // namespace etalon
