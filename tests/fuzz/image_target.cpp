#include "tests/fuzz/image_target.h"

#include <sanitizer/lsan_interface.h>

#include <algorithm>
#include <span>

#include "core/image/bilinear.h"
#include "core/image/io.h"
#include "core/image/lack_of_memory.h"
#include "core/numerics/same_bits.h"
#include "tests/fuzz/target.h"
#include "tests/temporary_folder.h"

namespace etalon::fuzz {
namespace {

void require_same(const Color& a, const Color& b) {
    for (int k = 0; k < 3; ++k) require(same_bits(a[k], b[k]), "another colour in compact form");
}

bool lacks_memory(const std::string& error) {
    return error.ends_with(lack_of_memory);
}

/// Returns whether memory is exhausted while a library reads a file that leaks then. Such leaks are
/// not reported.
bool may_leak(const std::string& name) {
    if (target.survives_lack_of_memory) return false;
    const __lsan::ScopedDisabler without_reports;
    return lacks_memory(read_image(name, Extent::whole).error);
}

/// Returns whether two images have the same pixels, bit for bit.
bool same_pixels(const Image& a, const Image& b) {
    const auto bytes = [](const auto& values) { return std::as_bytes(std::span(values)); };
    const auto first = std::visit(bytes, a.pixels), second = std::visit(bytes, b.pixels);
    return std::ranges::equal(first, second);
}

/// Requires that a file has the same pixels when it is read again, in the form that is compact if
/// the file has one, and there the same colours between them; some are compared. One form may need
/// more memory than there is.
void check_compact(const std::string& name, const Result<Image>& whole) {
    const Result<CompactImage> compact = read_compact_image(name);
    if (lacks_memory(compact.error) || lacks_memory(whole.error)) return;
    require(compact.error == whole.error, "an error in one form of the image only");
    if (!whole) return;
    const Image& image = whole.value;
    if (const Image* again = std::get_if<Image>(&compact.value)) {
        return require(same_pixels(image, *again), "other pixels when it is read again");
    }
    const auto& subsampled = std::get<SubsampledImage>(compact.value);
    BilinearPoints points;
    for (int k = 0; k < 5; ++k) {
        const int x = (image.width - 1) * k / 4, y = (image.height - 1) * k / 4;
        require_same(image.color(x, y), subsampled.color(x, y));
        points.add(image.width, image.height, k / 4.0, k / 4.0);
    }
    BilinearColors expected, found;
    interpolate(image, points, expected);
    interpolate(subsampled, points, found);
    for (std::size_t k = 0; k < points.count; ++k) require_same(expected[k], found[k]);
}

}  // namespace

void read_image_file(const std::string& name, std::string_view start, std::string_view bytes) {
    std::string file(start);
    if (bytes.size() > start.size()) file += bytes.substr(start.size());
    test::put(name, file);
    if (may_leak(name)) return;
    const Result<Image> header = read_image(name, Extent::header);
    const Result<Image> whole = read_image(name, Extent::whole);
    require(header || !header.error.empty(), "neither a header nor an error");
    require(whole || whole.error.starts_with(name),
            "neither an image nor an error that names the file");
    check_compact(name, whole);
    if (!whole) return;
    const Image& image = whole.value;
    require(header && header.value.width == image.width, "an image where the header is an error");
    const std::size_t size = std::size_t(image.width) * image.height * image.channels;
    require(std::visit([&](const auto& values) { return values.size() == size; }, image.pixels),
            "an image of another size");
    image.color(image.width - 1, image.height - 1);
}

}  // namespace etalon::fuzz
