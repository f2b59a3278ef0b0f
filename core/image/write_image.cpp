#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "core/image/exr.h"
#include "core/image/io.h"
#include "core/image/png.h"
#include "core/numerics/pixel_window.h"

namespace etalon {
namespace {

/// Returns the extension in lower case, with its dot.
std::string extension(const std::string& path) {
    std::string text = std::filesystem::path(path).extension().string();
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

}  // namespace etalon
