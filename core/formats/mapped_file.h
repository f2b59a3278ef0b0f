#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "core/formats/file_text.h"

namespace etalon {

/// The bytes of a file, mapped into memory, or an error. Nothing is copied, so the file must not be
/// truncated meanwhile. Files that cannot be mapped, such as pipes, are read.
class MappedFile {
  public:
    /// Maps a whole file of at most largest_file bytes.
    explicit MappedFile(const std::string& path, FileKind kind = FileKind::any);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept { *this = std::move(other); }
    MappedFile& operator=(MappedFile&& other) noexcept;

    std::string_view text() const {
        return mapped_ ? std::string_view(mapped_, size_) : read_.text();
    }
    const std::string& error() const { return read_.error; }  ///< empty on success

  private:
    std::size_t size_ = 0;
    const char* mapped_ = nullptr;  ///< declared after the size, which mapping sets
    FileText read_;                 ///< used if nothing is mapped
};

}  // namespace etalon
