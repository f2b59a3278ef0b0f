#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "core/formats/file_text.h"

namespace etalon {

/// The bytes of a file as pages of memory, or why there are none. Nothing is copied: the file must
/// not be made shorter meanwhile. What cannot be mapped, as a pipe, is read.
class MappedFile {
  public:
    /// Maps a whole file, but none larger than largest_file.
    explicit MappedFile(const std::string& path);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept { *this = std::move(other); }
    MappedFile& operator=(MappedFile&& other) noexcept;

    std::string_view text() const {
        return mapped_ ? std::string_view(mapped_, size_) : read_.text();
    }
    const std::string& error() const { return read_.error; }  ///< empty on success

  private:
    std::size_t size_ = 0;
    const char* mapped_ = nullptr;  ///< after the size, which mapping sets
    FileText read_;                 ///< where nothing is mapped
};

}  // namespace etalon
