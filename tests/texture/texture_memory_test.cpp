#include "core/texture/texture_memory.h"

#include "core/image/io.h"
#include "core/texture/texture_images.h"
#include "tests/catch.h"
#include "tests/heap_bytes.h"
#include "tests/sanitized.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Files of one colour in a folder, and textures that use them.
struct Files {
    TemporaryFolder folder;
    Textures textures;

    void add(const std::string& name, int width, int height) {
        RenderedImage image{};
        image.width = width;
        image.height = height;
        image.window = {{0, 0}, {width - 1, height - 1}};
        image.display_colors = true;
        image.pixels.assign(static_cast<std::size_t>(width) * height, Color(0.4F, 0.5F, 0.6F));
        REQUIRE(write_image(folder / name, image).empty());
        textures.images.push_back({folder / name, Wrap::repeat, name.ends_with(".png"), 1});
    }
    std::uint32_t last() const { return static_cast<std::uint32_t>(textures.images.size() - 1); }
    void show_colors() { textures.colors.emplace_back(ImageTexture<Color>{UvMapping{}, last()}); }
    void show_numbers() { textures.numbers.emplace_back(ImageTexture<float>{UvMapping{}, last()}); }
};

}  // namespace

TEST_CASE("an image of bytes takes four bytes a texel or less, whatever its sides", "[texture]") {
    for (const bool as_colors : {true, false}) {
        for (const auto& [width, height] : {std::pair(512, 1024), {500, 1000}}) {
            Files files;
            files.add("image.png", width, height);
            as_colors ? files.show_colors() : files.show_numbers();
            const std::size_t told = texture_memory_bytes(files.textures);
            const bool as_in_file = as_colors && width == 512;
            CHECK(told == std::size_t{512} * 1024 * (as_in_file ? 3 : 4));

            std::vector<std::string> problems;
            const std::size_t before = heap_bytes();
            const TextureImages images = read_texture_images(files.textures, problems);
            const std::size_t taken = heap_bytes() - before;
            INFO(width << ' ' << as_colors << ' ' << taken << " of " << told);
            CHECK(problems.empty());
            if (is_sanitized) continue;  // which has a heap of its own
            CHECK(taken >= told);
            CHECK(taken < told + told / 50);
        }
    }
}

TEST_CASE("textures that show the same of a file share its texels", "[texture]") {
    Files files;
    files.add("image.png", 100, 200);
    files.show_colors();
    const std::size_t one = texture_memory_bytes(files.textures);
    files.textures.images.push_back(files.textures.images[0]);
    files.textures.images[1].scale = 2;
    files.show_colors();
    CHECK(texture_memory_bytes(files.textures) == one);
    files.textures.images[1].wrap = Wrap::clamp;
    CHECK(texture_memory_bytes(files.textures) == 2 * one);
}

TEST_CASE("images of floats, and those that are not shown, take what they hold", "[texture]") {
    Files files;
    files.add("image.exr", 64, 32);
    CHECK(texture_memory_bytes(files.textures) == 0);
    files.show_colors();
    CHECK(texture_memory_bytes(files.textures) == 64 * 32 * 12);
    files.textures.images[0].file = files.folder / "missing.exr";
    CHECK(texture_memory_bytes(files.textures) == 4);
}
