#include "core/image/exr_zip.h"

#include <libdeflate.h>

#include <memory>
#include <new>

namespace etalon {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Compression level, chosen by measurement: the next is 1 % smaller and takes a quarter longer.
constexpr int level = 1;

struct FreeCompressor {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};

/// Separates even bytes from odd ones, so that the slowly varying bytes of floats are together.
Bytes split(const Bytes& block) {
    Bytes parts(block.size());
    std::uint8_t* even = parts.data();
    std::uint8_t* odd = even + (block.size() + 1) / 2;
    for (std::size_t i = 0; i + 1 < block.size(); i += 2) {
        *even++ = block[i];
        *odd++ = block[i + 1];
    }
    if (block.size() % 2 != 0) *even = block.back();
    return parts;
}

/// Replaces each byte by its difference from the one before, plus 128.
Bytes differences(const Bytes& bytes) {
    Bytes result(bytes);
    for (std::size_t i = 1; i < bytes.size(); ++i) {
        result[i] = static_cast<std::uint8_t>(bytes[i] - bytes[i - 1] + 128);
    }
    return result;
}

}  // namespace

Bytes zip_exr_block(Bytes block) {
    const Bytes input = differences(split(block));
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(level));
    if (!compressor) throw std::bad_alloc();
    Bytes output(input.size());
    const std::size_t size = libdeflate_zlib_compress(compressor.get(), input.data(), input.size(),
                                                      output.data(), output.size() - 1);
    if (size == 0) return block;
    output.resize(size);
    return output;
}

}  // namespace etalon
