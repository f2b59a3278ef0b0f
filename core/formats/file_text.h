#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace etalon {

/// The bytes of a file, or why there are none.
struct FileText {
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;
    std::string error;  ///< empty on success

    std::string_view text() const { return {bytes.get(), size}; }
};

/// Size limit in bytes. Every item of a scene takes at least 6 ("0 0 0 "), so the items of a file
/// of this size can still be numbered with 32 bits.
inline constexpr std::size_t largest_file = std::size_t{1} << 34;

/// What may be read. A pipe that a scene names might never have a writer; one that the user names
/// has one.
enum class FileKind { any, regular };

/// Reads a whole file of at most largest_file bytes; "-" is standard input.
FileText read_file(const std::string& path, FileKind kind = FileKind::any);

}  // namespace etalon
