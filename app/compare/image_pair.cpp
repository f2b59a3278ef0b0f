#include "app/compare/image_pair.h"

#include <fmt/core.h>

#include "core/image/io.h"
#include "core/parallel/parallel.h"

namespace etalon::compare {
namespace {

std::string extent(const std::string& path, const Image& image) {
    const std::string size = fmt::format("{}: {} x {} pixels", path, image.width, image.height);
    return image.origin ? fmt::format("{} at {},{}", size, image.origin->x, image.origin->y) : size;
}

bool same_extent(const Image& a, const Image& b) {
    const bool same_place = !a.origin || !b.origin || *a.origin == *b.origin;
    return a.width == b.width && a.height == b.height && same_place;
}

/// Whether the pair is compared by display values: one has them, and the other, if a PNG, may have
/// them too.
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
    if (!same_extent(p, q)) {
        return {{}, fmt::format("{}; {}; expected the same", extent(a, p), extent(b, q))};
    }
    const auto pixels_of = has_display_values(p, q) ? display_pixels : linear_pixels;
    ImagePair images{p.width, p.height, {}};
    parallel_invoke([&] { images.pixels[0] = pixels_of(p); },
                    [&] { images.pixels[1] = pixels_of(q); });
    return {std::move(images), {}};
}

}  // namespace etalon::compare
