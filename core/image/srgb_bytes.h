#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Computes the bytes nearest to sRGB's curve from the 255 values at which they change, not by
/// powers.
class SrgbBytes {
  public:
    SrgbBytes();

    /// Returns the byte of a linear value in [0, 1].
    std::uint8_t operator()(double linear) const {
        const std::uint8_t byte = first_bytes_[cell(linear)];
        return static_cast<std::uint8_t>(byte + (linear >= least_[byte + 1]));
    }

  private:
    /// Cells of values with the same leading bits, so small that no cell has two changes in it. All
    /// values below 2^-13 are black.
    static constexpr int mantissa_bits = 7, shift = 52 - mantissa_bits;
    static constexpr std::uint64_t origin = std::bit_cast<std::uint64_t>(0x1p-13) >> shift;
    static constexpr std::uint64_t last = (std::bit_cast<std::uint64_t>(1.0) >> shift) - origin;

    static std::size_t cell(double linear) {
        const std::uint64_t bits = std::bit_cast<std::uint64_t>(linear) >> shift;
        return bits < origin ? 0 : bits - origin;
    }

    std::array<double, 257> least_;  ///< least value of each byte; the last is out of reach
    std::array<std::uint8_t, last + 1> first_bytes_;
};

}  // namespace etalon
