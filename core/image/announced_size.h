// Whether a file may contain the image that its header announces, before memory is taken for it.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace etalon {

/// Number of bytes from a file's start that bytes_at_opening() needs.
inline constexpr std::size_t announcement_size = 26;

/// Returns the little-endian number of `size` bytes at an offset; 0 beyond the end.
inline std::int64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
    if (bytes.size() < at + size) return 0;
    std::int64_t number = 0;
    for (std::size_t i = size; i > 0; --i) {
        number = number << 8 | static_cast<unsigned char>(bytes[at + i - 1]);
    }
    return number;
}

/// Returns the bytes of the image, with four channels, for formats whose readers allocate all of it
/// when they open a file; 0 for others.
inline std::int64_t bytes_at_opening(std::string_view start) {
    if (start.starts_with("GIF8")) return 4 * number_at(start, 6, 2) * number_at(start, 8, 2);
    if (!start.starts_with("BM")) return 0;
    const auto height =
        static_cast<std::int32_t>(number_at(start, 22, 4));  // below 0: from the top
    return 4 * number_at(start, 18, 4) * std::abs(std::int64_t{height});
}

/// Returns whether a file is large enough for so many bytes of pixels. A GIF of one colour has a
/// 5500th of them; only formats with better compression, as WebP, can have less. Small images may.
inline bool may_contain(const char* path, std::int64_t bytes) {
    constexpr std::int64_t harmless = 1 << 27, highest_ratio = 6000;
    if (bytes <= harmless) return true;
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    return !unknown && static_cast<std::uintmax_t>(bytes / highest_ratio) <= size;
}

}  // namespace etalon
