#include "app/compare/image_pair.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "core/image/io.h"
#include "core/numerics/pixel_window.h"
#include "core/parallel/parallel.h"

namespace etalon::compare {
namespace {

Imath::V2i size_of(const Image& image) {
    return {image.width, image.height};
}

std::string place_text(const Imath::V2i& size, const std::optional<Imath::V2i>& origin) {
    const std::string text = fmt::format("{} x {} pixels", size.x, size.y);
    return origin ? fmt::format("{} at {},{}", text, origin->x, origin->y) : text;
}

bool are_of_one_frame(const Image& a, const Image& b) {
    return !a.frame || !b.frame || *a.frame == *b.frame;
}

/// Returns the image's extent and, if frames differ, its frame.
std::string extent(const std::string& path, const Image& image, bool with_frame) {
    const std::string text = path + ": " + place_text(size_of(image), image.origin);
    if (!with_frame) return text;
    const Imath::Box2i& frame = *image.frame;
    return text + " of a frame of " + place_text(window_size(frame), frame.min);
}

bool same_extent(const Image& a, const Image& b) {
    const bool same_place = !a.origin || !b.origin || *a.origin == *b.origin;
    return size_of(a) == size_of(b) && same_place;
}

/// Returns the position of an image in the frame that it shares with another one. An image without
/// a position, as the PNG of a whole image, begins where the frame does if it can be all of it.
std::optional<Imath::Box2i> place_of(const Image& image, const Image& other) {
    const Imath::V2i size = size_of(image);
    if (image.origin) return Imath::Box2i(*image.origin, *image.origin + size - Imath::V2i(1));
    if (!other.origin) return std::nullopt;
    const Imath::V2i first = other.frame ? other.frame->min : Imath::V2i(0);
    const Imath::V2i end = *other.origin + size_of(other);
    const Imath::Box2i all(first, first + size - Imath::V2i(1));
    const bool is_all = other.frame ? all == *other.frame : end.x <= size.x && end.y <= size.y;
    return is_all ? std::optional(all) : std::nullopt;
}

/// Returns the part of their frame that both show, if they overlap.
std::optional<Imath::Box2i> overlap(const Image& a, const Image& b) {
    const auto p = place_of(a, b), q = place_of(b, a);
    if (!p || !q) return std::nullopt;
    const Imath::Box2i both = common_window(*p, *q);
    return both.isEmpty() ? std::nullopt : std::optional(both);
}

/// Crops both to a window of the frame.
void cut(ImagePair& images, const Image& a, const Image& b, const Imath::Box2i& window) {
    const auto cut_one = [&](std::vector<Color>& pixels, const Image& image, const Image& other) {
        const Imath::V2i first = place_of(image, other)->min;
        pixels = cut_out(pixels, image.width, {window.min - first, window.max - first});
    };
    cut_one(images.pixels[0], a, b);
    cut_one(images.pixels[1], b, a);
    const Imath::V2i size = window_size(window);
    images.width = size.x, images.height = size.y;
    images.window = window;
}

/// Returns whether the pair is compared by display values: one has them, and the other, if a PNG,
/// may have them too.
bool has_display_values(const Image& a, const Image& b) {
    const auto has = [&](Encoding e) { return a.encoding == e || b.encoding == e; };
    return has(Encoding::display) && !has(Encoding::linear);
}

}  // namespace

Result<ImagePair> read_image_pair(const std::string& a, const std::string& b) {
    Result<Image> first, second;
    parallel_invoke([&] { first = read_image(a); }, [&] { second = read_image(b); });
    if (!first) return {{}, first.error};
    if (!second) return {{}, second.error};
    Image &p = first.value, &q = second.value;
    const bool is_whole = same_extent(p, q), other_frame = !are_of_one_frame(p, q);
    const std::optional<Imath::Box2i> both = is_whole ? std::nullopt : overlap(p, q);
    if (other_frame || (!is_whole && !both)) {
        return {{},
                fmt::format("{}; {}; expected images of one frame that overlap",
                            extent(a, p, other_frame), extent(b, q, other_frame))};
    }
    ImagePair images{p.width, p.height, {}, has_display_values(p, q)};
    const auto pixels_of = images.has_display_values ? display_pixels : linear_pixels;
    parallel_invoke([&] { images.pixels[0] = pixels_of(p); },
                    [&] { images.pixels[1] = pixels_of(q); });
    if (both) cut(images, p, q, *both);
    return {std::move(images), {}};
}

}  // namespace etalon::compare
