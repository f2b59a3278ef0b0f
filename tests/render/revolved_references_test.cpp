// Pictures by pbrt-v3 of parts of each surface of revolution, beside those of the path tracer.
#include "core/formats/load.h"
#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr int block_side = 6;

std::string path_of(std::string_view shape, std::string_view extension) {
    return std::string(ETALON_SOURCE_DIR "/tests/references/pbrt/").append(shape).append(extension);
}

/// Largest differences of two pictures, relative to the brightest channel's mean.
struct Difference {
    double mean = 0, block = 0;
};

struct Block {
    int x, y, width, height;
};

double mean_of(const Image& reference, const std::vector<Color>* image, int channel,
               const Block& b) {
    double sum = 0;
    for (int y = b.y; y < b.y + b.height; ++y) {
        for (int x = b.x; x < b.x + b.width; ++x) {
            const auto pixel = static_cast<std::size_t>(y) * reference.width + x;
            sum += (image != nullptr ? (*image)[pixel] : reference.color(x, y))[channel];
        }
    }
    return sum / (b.width * b.height);
}

Difference difference(const Image& reference, const std::vector<Color>& image) {
    const Block whole{0, 0, reference.width, reference.height};
    double brightest = 0;
    for (int channel = 0; channel < 3; ++channel) {
        brightest = std::max(brightest, mean_of(reference, nullptr, channel, whole));
    }
    Difference found;
    const auto add = [&](double& largest, int channel, const Block& block) {
        const double off = mean_of(reference, &image, channel, block) -
                           mean_of(reference, nullptr, channel, block);
        largest = std::max(largest, std::abs(off) / brightest);
    };
    for (int channel = 0; channel < 3; ++channel) {
        add(found.mean, channel, whole);
        for (int y = 0; y < reference.height; y += block_side) {
            for (int x = 0; x < reference.width; x += block_side) {
                add(found.block, channel, {x, y, block_side, block_side});
            }
        }
    }
    return found;
}

Difference difference_of(std::string_view shape) {
    const LoadResult loaded = load_scene(path_of(shape, ".pbrt"));
    REQUIRE(loaded.scene);
    REQUIRE(loaded.diagnostics.empty());
    const Result<Image> reference = read_image(path_of(shape, ".pfm"));
    REQUIRE(reference);
    RenderSettings settings = loaded.settings;
    settings.samples_per_pixel = 256;
    const auto picture =
        render_with(*loaded.scene, *find_backend(default_backend), settings).film.pixels();
    return difference(reference.value, picture);
}

}  // namespace

TEST_CASE("Parts of surfaces of revolution look as in pbrt-v3, in the colours of u and v") {
    for (const std::string_view shape :
         {"sphere", "cylinder", "cone", "paraboloid", "hyperboloid", "disk"}) {
        const Difference d = difference_of(shape);
        CAPTURE(shape, d.mean, d.block);
        CHECK(d.mean < 1e-3);
        CHECK(d.block < 1.5e-2);
    }
}
