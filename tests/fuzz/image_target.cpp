#include "tests/fuzz/image_target.h"

#include "core/image/io.h"
#include "core/numerics/same_bits.h"
#include "tests/fuzz/target.h"
#include "tests/temporary_folder.h"

namespace etalon::fuzz {
namespace {

/// Requires that a file has the same pixels in compact form, of which a few are compared.
void check_compact(const std::string& name, const Result<Image>& whole) {
    const Result<CompactImage> compact = read_compact_image(name);
    require(compact.error == whole.error, "an error in one form of the image only");
    if (!compact || !whole) return;
    const Image& image = whole.value;
    for (int k = 0; k < 5; ++k) {
        const int x = (image.width - 1) * k / 4, y = (image.height - 1) * k / 4;
        const auto color = [&](const auto& form) { return form.color(x, y); };
        const Color a = image.color(x, y), b = std::visit(color, compact.value);
        for (int c = 0; c < 3; ++c)
            require(same_bits(a[c], b[c]), "another colour in compact form");
    }
}

}  // namespace

void read_image_file(const std::string& name, std::string_view start, std::string_view bytes) {
    std::string file(start);
    if (bytes.size() > start.size()) file += bytes.substr(start.size());
    test::put(name, file);
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
