#include "tests/fuzz/image_target.h"

#include "core/image/io.h"
#include "tests/fuzz/target.h"
#include "tests/temporary_folder.h"

namespace etalon::fuzz {

void read_image_file(const std::string& name, std::string_view start, std::string_view bytes) {
    std::string file(start);
    if (bytes.size() > start.size()) file += bytes.substr(start.size());
    test::put(name, file);
    const Result<Image> header = read_image(name, Extent::header);
    const Result<Image> whole = read_image(name, Extent::whole);
    require(header || !header.error.empty(), "neither a header nor an error");
    require(whole || whole.error.starts_with(name),
            "neither an image nor an error that names the file");
    if (!whole) return;
    const Image& image = whole.value;
    require(header && header.value.width == image.width, "an image where the header is an error");
    const std::size_t size = std::size_t(image.width) * image.height * image.channels;
    require(std::visit([&](const auto& values) { return values.size() == size; }, image.pixels),
            "an image of another size");
    image.color(image.width - 1, image.height - 1);
}

}  // namespace etalon::fuzz
