#include "core/image/io.h"

#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
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
#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "core/image/exr.h"
#include "core/image/jpeg_read.h"
#include "core/image/lack_of_memory.h"
#include "core/image/oiio.h"
#include "core/image/png.h"
#include "core/numerics/pixel_window.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

/// Returns the extension in lower case, with its dot.
std::string extension(const std::string& path) {
    std::string text = fs::path(path).extension().string();
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_consistent(const RenderedImage& image) {
    if (image.width < 1 || image.height < 1 || image.window.isEmpty()) return false;
    const Imath::V2i last = image.window.size();
    const std::size_t size =
        (static_cast<std::size_t>(last.x) + 1) * (static_cast<std::size_t>(last.y) + 1);
    return image.pixels.size() == size &&
           std::all_of(image.channels.begin(), image.channels.end(),
                       [&](const Channel& c) { return c.size() == size; });
}

/// Keywords of a PNG, and the metadata that they stand for: only what the pixels depend on, so that
/// equal images are equal files.
constexpr std::pair<const char*, const char*> png_keywords[] = {
    {"Software", "software"},
    {"scene", "scene"},
    {"seed", "seed"},
    {"samplesPerPixel", "samplesPerPixel"}};

std::string text_of(const RenderedImage::Attribute& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const auto* number = std::get_if<float>(&value);
    return number != nullptr ? fmt::format("{}", *number) : "";
}

PngFacts png_facts(const RenderedImage& image) {
    PngFacts facts;
    const Imath::V2i size = window_size(image.window);
    if (size != Imath::V2i(image.width, image.height)) facts.origin = image.window.min;
    for (const auto& [keyword, name] : png_keywords) {
        const auto found = image.metadata.find(name);
        if (found != image.metadata.end())
            facts.texts.emplace_back(keyword, text_of(found->second));
    }
    return facts;
}

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

/// Reads a file whose first bytes tell its format, or nothing.
std::optional<Result<Image>> read_known(const std::string& path, Extent extent) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) return std::nullopt;
    std::array<char, 8> bytes{};
    const std::size_t size = std::fread(bytes.data(), 1, bytes.size(), file.get());
    const std::string_view start(bytes.data(), size);
    std::rewind(file.get());
    if (start.empty()) return Result<Image>{{}, "the file is empty"};
    if (start.starts_with("\x76\x2f\x31\x01")) return read_exr(path, extent);
    if (start.starts_with("\x89PNG\r\n\x1a\n")) return read_png(file.get(), extent);
    if (start.starts_with("\xff\xd8")) return read_jpeg(file.get(), extent);
    return std::nullopt;
}

Result<Image> read_by_kind(const std::string& path, Extent extent) {
    if (std::optional<Result<Image>> image = read_known(path, extent)) return std::move(*image);
    return read_oiio(path, extent);
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

Result<Image> read_readable(const std::string& path, Extent extent) {
    const std::string error = check_readable(path);
    if (!error.empty()) return {{}, error};
    note_content(path);
    try {
        return read_by_kind(path, extent);
    } catch (const std::bad_alloc&) {
        return {{}, lack_of_memory};
    }
}

constexpr std::string_view before_reason = ": cannot be read: ";

}  // namespace

bool can_write(const std::string& path) {
    const std::string kind = extension(path);
    return kind == ".exr" || kind == ".png";
}

bool can_hold_channels(const std::string& path) {
    return extension(path) == ".exr";
}

bool has_exposure(const std::string& path) {
    return extension(path) == ".png";
}

Result<std::string> encode_image(const std::string& name, const RenderedImage& image,
                                 double exposure) {
    const std::string kind = extension(name);
    if (!is_consistent(image)) return {{}, "its window and its pixels do not agree"};
    if (kind == ".exr") return encode_exr(image);
    if (kind == ".png") {
        const Imath::V2i size = window_size(image.window);
        return encode_png(display_bytes(image, exposure), size.x, size.y, png_facts(image));
    }
    return {{}, "expected a name ending in .exr or .png"};
}

std::string write_image(const std::string& path, const RenderedImage& image, double exposure) {
    const Result<std::string> file = encode_image(path, image, exposure);
    if (!file) return path + ": cannot be written: " + file.error;
    return write_file_atomically(path, file.value);
}

Result<Image> read_image(const std::string& path, Extent extent) {
    constexpr std::size_t longest = 400;
    Result<Image> image = read_readable(path, extent);
    if (!image) {
        const std::string reason = printable(image.error, longest);
        image.error = path_in_reason(path).append(before_reason).append(reason);
    }
    return image;
}

std::string path_in_reason(const std::string& path) {
    constexpr std::size_t longest = 1000;
    return printable(path, longest);
}

std::string path_of_reason(const std::string& reason) {
    return reason.substr(0, reason.rfind(before_reason));
}

}  // namespace etalon
