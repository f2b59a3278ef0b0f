#include "core/image/exr_zip.h"

#include <new>

namespace etalon {
namespace {

/// Compression level, chosen by measurement: the next is 1 % smaller and takes a quarter longer.
constexpr int level = 1;

/// Writes every other byte from `first` on, each less the one before it there, plus 128; the first
/// one less `before`. Returns the end of what was written. Apart from those of the other bytes, the
/// slowly varying bytes of floats are together.
std::uint8_t* write_differences(std::span<const std::uint8_t> block, std::size_t first,
                                std::uint8_t before, std::uint8_t* to) {
    if (first >= block.size()) return to;
    *to++ = static_cast<std::uint8_t>(block[first] - before + 128);
    const std::uint8_t* const from = block.data() + first;
    const std::size_t steps = (block.size() - first - 1) / 2;
    for (std::size_t i = 0; i < steps; ++i) {
        to[i] = static_cast<std::uint8_t>(from[2 * i + 2] - from[2 * i] + 128);
    }
    return to + steps;
}

}  // namespace

ExrZip::ExrZip() : compressor_(libdeflate_alloc_compressor(level)) {
    if (!compressor_) throw std::bad_alloc();
}

std::span<const std::uint8_t> ExrZip::operator()(std::span<const std::uint8_t> block) {
    differences_.resize(block.size());
    compressed_.resize(block.size());
    // The first byte of all is stored as it is.
    std::uint8_t* const odd = write_differences(block, 0, 128, differences_.data());
    const std::size_t last_even = (block.size() - 1) / 2 * 2;
    write_differences(block, 1, block[last_even], odd);
    const std::size_t size =
        libdeflate_zlib_compress(compressor_.get(), differences_.data(), differences_.size(),
                                 compressed_.data(), compressed_.size() - 1);
    if (size == 0) return block;
    return std::span(compressed_).first(size);
}

}  // namespace etalon
