#include <cstdint>
#include <cstring>
#include <numbers>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/inventory/worlds.h"
#include "tests/temporary_folder.h"

namespace etalon::test {
namespace {

void write_map(const std::string& path, const Color& brightest) {
    constexpr int width = 8, height = 4;
    RenderedImage image{};
    image.width = width;
    image.height = height;
    image.window = {{0, 0}, {width - 1, height - 1}};
    image.display_colors = true;
    for (int i = 0; i < width * height; ++i) {
        image.pixels.push_back(brightest * (0.2F + static_cast<float>(i * 7 % 32) / 40));
    }
    REQUIRE(write_image(path, image).empty());
}

void write_ply(const std::string& path, const std::string& corner) {
    put(path,
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float u\nproperty float v\nelement face 2\n"
        "property list uchar int vertex_indices\nend_header\n"
        "-1 -1 0 0 0\n1 -1 0 1 0\n" +
            corner + " 1 1\n-1 1 0 0 1\n3 0 1 2\n3 0 2 3\n");
}

/// The 32-bit words of a table of pbrt-v3's Fourier BSDFs.
class Words {
  public:
    void integer(std::int32_t x) { append(x); }
    void number(float x) { append(x); }
    const std::string& text() const { return text_; }

  private:
    template <class T>
    void append(T x) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &x, sizeof(T));
        text_.append(bytes, sizeof(T));
    }
    std::string text_{"SCATFUN\x01"};
};

/// A surface that reflects this fraction of the light diffusely: one coefficient for each pair of
/// directions on the same side.
void write_bsdf(const std::string& path, float albedo) {
    constexpr float mu[] = {-1, -0.5F, -0.05F, 0.05F, 0.5F, 1};
    constexpr int count = 6;
    Words words;
    for (const int x : {1, count, count * count, 1, 1, 1, 0, 0, 0}) words.integer(x);
    words.number(1);
    for (int i = 0; i < 4; ++i) words.integer(0);
    for (const float x : mu) words.number(x);
    const auto value = [&](int o, int i) {
        const bool is_reflected = mu[o] * mu[i] < 0;  // the incident direction is reversed
        return is_reflected ? albedo / std::numbers::pi_v<float> * std::abs(mu[i]) : 0.0F;
    };
    for (int o = 0; o < count; ++o) {
        float sum = 0;
        for (int i = 0; i < count; ++i) {
            if (i > 0) sum += (value(o, i) + value(o, i - 1)) / 2 * (mu[i] - mu[i - 1]);
            words.number(sum);
        }
    }
    for (int k = 0; k < count * count; ++k) {
        words.integer(k);
        words.integer(1);
    }
    for (int o = 0; o < count; ++o) {
        for (int i = 0; i < count; ++i) words.number(value(o, i));
    }
    put(path, words.text());
}

}  // namespace

void write_files(const std::string& folder) {
    write_map(folder + "/a.png", Color(0.9F, 0.5F, 0.3F));
    write_map(folder + "/b.png", Color(0.2F, 0.7F, 0.5F));
    write_ply(folder + "/a.ply", "1 1 0");
    write_ply(folder + "/b.ply", "1 .3 0");
    put(folder + "/lens.dat", "50 4 1.5 20\n0 1 0 15\n-50 45 1 20\n");
    put(folder + "/other.dat", "30 4 1.5 20\n0 1 0 10\n-30 25 1 20\n");
    write_bsdf(folder + "/a.bsdf", 0.8F);
    write_bsdf(folder + "/b.bsdf", 0.3F);
}

}  // namespace etalon::test
