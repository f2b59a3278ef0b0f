#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <system_error>

#include "core/base/printable.h"
#include "core/base/read_log.h"
#include "core/base/uninterrupted.h"
#include "core/image/exr.h"
#include "core/image/io.h"
#include "core/image/jpeg_read.h"
#include "core/image/lack_of_memory.h"
#include "core/image/oiio.h"
#include "core/image/png.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

/// Returns why no file can be read there, as far as the file system knows; libraries' messages are
/// worse.
std::string check_readable(const std::string& path) {
    if (::access(path.c_str(), R_OK) != 0) return error_text(errno);
    std::error_code none;
    if (fs::is_directory(path, none)) return error_text(EISDIR);
    if (!fs::is_regular_file(path, none)) return "a pipe or device; expected a file";
    return {};
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// What is read of a file, and in which form.
struct Reading {
    Extent extent;
    bool is_compact;
};

Result<CompactImage> as_compact(Result<Image> image) {
    return {std::move(image.value), std::move(image.error)};
}

/// Reads a file whose first bytes tell its format, or nothing.
std::optional<Result<CompactImage>> read_known(const std::string& path, const Reading& what) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) return std::nullopt;
    std::array<char, 8> bytes{};
    const std::size_t size = std::fread(bytes.data(), 1, bytes.size(), file.get());
    const std::string_view start(bytes.data(), size);
    std::rewind(file.get());
    if (start.empty()) return Result<CompactImage>{{}, "the file is empty"};
    if (start.starts_with("\x76\x2f\x31\x01")) return as_compact(read_exr(path, what.extent));
    if (start.starts_with("\x89PNG\r\n\x1a\n"))
        return as_compact(read_png(file.get(), what.extent));
    if (!start.starts_with("\xff\xd8")) return std::nullopt;
    if (what.is_compact) return read_compact_jpeg(file.get());
    return as_compact(read_jpeg(file.get(), what.extent));
}

Result<CompactImage> read_by_kind(const std::string& path, const Reading& what) {
    if (auto image = read_known(path, what)) return std::move(*image);
    return as_compact(read_oiio(path, what.extent));
}

/// Records the file's contents for the identity of the scene.
void note_content(const std::string& path) {
    if (!ReadLog::needs_contents()) return ReadLog::note_hash(path, 0);
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    Hash64 hash;
    std::vector<char> bytes(1 << 16);
    for (std::size_t size = bytes.size(); file && size == bytes.size();) {
        size = std::fread(bytes.data(), 1, bytes.size(), file.get());
        hash.add({bytes.data(), size});
    }
    ReadLog::note_hash(path, hash.value());
}

Result<CompactImage> read_readable(const std::string& path, const Reading& what) {
    const std::string error = check_readable(path);
    if (!error.empty()) return {{}, error};
    note_content(path);
    try {
        return read_by_kind(path, what);
    } catch (const std::bad_alloc&) {
        return {{}, lack_of_memory};
    }
}

constexpr std::string_view before_reason = ": cannot be read: ";

Result<CompactImage> read(const std::string& path, const Reading& what) {
    constexpr std::size_t longest = 400;
    Result<CompactImage> image = read_readable(path, what);
    if (!image) {
        const std::string reason = printable(image.error, longest);
        image.error = path_in_reason(path).append(before_reason).append(reason);
    }
    return image;
}

}  // namespace

Result<Image> read_image(const std::string& path, Extent extent) {
    Result<CompactImage> image = read(path, {extent, false});
    return {std::get<Image>(std::move(image.value)), std::move(image.error)};
}

Result<CompactImage> read_compact_image(const std::string& path) {
    return read(path, {Extent::whole, true});
}

std::string path_in_reason(const std::string& path) {
    constexpr std::size_t longest = 1000;
    return printable(path, longest);
}

std::string path_of_reason(const std::string& reason) {
    return reason.substr(0, reason.rfind(before_reason));
}

}  // namespace etalon
