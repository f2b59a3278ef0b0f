#include "app/compare/pictures.h"

#include <fmt/core.h>

#include "core/image/io.h"
#include "core/parallel/parallel.h"

namespace etalon::compare {
namespace {

/// A file as it was read, let go once its pixels are linear.
struct Read {
    Outcome<Image> file;
    std::vector<Color> pixels;
};

Read read(const std::string& path) {
    Read r{read_image(path), {}};
    if (r.file) r.pixels = linear_pixels(r.file.value);
    r.file.value.pixels = {};
    return r;
}

std::string extent(const std::string& path, const Image& image) {
    const std::string size = fmt::format("{}: {} x {} pixels", path, image.width, image.height);
    return image.origin ? fmt::format("{} at {},{}", size, image.origin->x, image.origin->y) : size;
}

bool same_extent(const Image& a, const Image& b) {
    const bool same_place = !a.origin || !b.origin || *a.origin == *b.origin;
    return a.width == b.width && a.height == b.height && same_place;
}

}  // namespace

Outcome<Pictures> read_pictures(const std::string& a, const std::string& b) {
    Read first, second;
    parallel_invoke([&] { first = read(a); }, [&] { second = read(b); });
    for (const Read* r : {&first, &second}) {
        if (!r->file) return {{}, r->file.error};
    }
    const Image &p = first.file.value, &q = second.file.value;
    if (!same_extent(p, q)) {
        return {{}, fmt::format("{}; {}; expected the same", extent(a, p), extent(b, q))};
    }
    return {{p.width, p.height, {std::move(first.pixels), std::move(second.pixels)}}, {}};
}

}  // namespace etalon::compare
