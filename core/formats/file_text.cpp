#include "core/formats/file_text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace etalon {
namespace {

std::string reason() {
    return std::generic_category().message(errno);
}

/// To the end of the stream; `expected` bytes are read in one go.
FileText read_all(std::FILE* file, std::size_t expected) {
    FileText result;
    std::size_t size = 0, wanted = expected + 1;  // one more, to meet the end at once
    while (true) {
        result.text.resize(size + wanted);
        const std::size_t got = std::fread(&result.text[size], 1, wanted, file);
        size += got;
        if (got < wanted) break;
        wanted = std::max<std::size_t>(size, 1 << 16);
    }
    if (std::ferror(file)) result.error = "cannot be read: " + reason();
    result.text.resize(size);
    return result;
}

}  // namespace

FileText read_file(const std::string& path) {
    if (path == "-") return read_all(stdin, 0);
    std::error_code unknown;
    if (std::filesystem::is_directory(path, unknown)) return {{}, "is a directory"};
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    if (!file) return {{}, "cannot be opened: " + reason()};
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    return read_all(file.get(), unknown ? 0 : static_cast<std::size_t>(size));
}

}  // namespace etalon
