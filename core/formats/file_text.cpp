#include "core/formats/file_text.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "core/base/read_log.h"
#include "core/base/uninterrupted.h"

namespace etalon {
namespace {

std::string reason() {
    return error_text(errno);
}

FileText failure(std::string error) {
    return {nullptr, 0, std::move(error)};
}

FileText too_large() {
    return failure("is larger than 16 GiB");
}

/// Reads to the end of the stream; a file of `expected` bytes is read in one go.
FileText read_all(std::FILE* stream, std::size_t expected) {
    std::size_t capacity = std::max<std::size_t>(expected, 1 << 16) + 1;  // one more finds the end
    FileText file{std::make_unique_for_overwrite<char[]>(capacity), 0, {}};
    while (true) {
        file.size += std::fread(&file.bytes[file.size], 1, capacity - file.size, stream);
        if (file.size < capacity) break;
        if (file.size > largest_file) return too_large();
        capacity *= 2;
        auto larger = std::make_unique_for_overwrite<char[]>(capacity);
        std::copy_n(file.bytes.get(), file.size, larger.get());
        file.bytes = std::move(larger);
    }
    if (std::ferror(stream)) return failure("cannot be read: " + reason());
    return file;
}

FileText read_unnoted(const std::string& path, FileKind kind) {
    if (path == "-" && kind == FileKind::any) return read_all(stdin, 0);
    std::error_code unknown;
    const std::filesystem::file_status status = std::filesystem::status(path, unknown);
    if (std::filesystem::is_directory(status)) return failure("is a directory");
    if (kind == FileKind::regular && std::filesystem::exists(status) &&
        !std::filesystem::is_regular_file(status)) {
        return failure("is a pipe or device; expected a file");
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    if (!file) return failure("cannot be opened: " + reason());
    if (std::filesystem::is_character_file(path, unknown) && !::isatty(::fileno(file.get()))) {
        return failure("is a device, which may have no end");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    if (unknown) return read_all(file.get(), 0);
    return size > largest_file ? too_large() : read_all(file.get(), size);
}

}  // namespace

FileText read_file(const std::string& path, FileKind kind) {
    FileText file = read_unnoted(path, kind);
    if (file.error.empty()) ReadLog::note(path, file.text());
    return file;
}

}  // namespace etalon
