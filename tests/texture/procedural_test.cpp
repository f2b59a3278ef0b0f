// Values of pbrt-v3's own classes, printed by a program linked with its sources, in single
// precision, with an identity mapping and dpdx and dpdy of 0.
#include "core/texture/procedural.h"

#include <array>
#include <string_view>

#include "core/texture/gradient_noise.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

struct PbrtValues {
    Vec3 position;
    float noise;
    float fbm;       ///< octaves 8, roughness 0.5
    float wrinkled;  ///< octaves 4, roughness 0.7
    float windy;
    Color marble;  ///< octaves 8, roughness 0.5, scale 2, variation 10
};

const std::array<PbrtValues, 6> pbrt_values = {{
    {{0.3, 0.6, 0.1},
     -0.1095832F,
     0.1071132F,
     0.4895154F,
     0.009946148F,
     {0.8639919F, 0.8639504F, 0.8923035F}},
    {{1.25, -2.75, 3.4},
     0.2232117F,
     0.4407859F,
     0.6749023F,
     0.2441165F,
     {0.8279669F, 0.8259525F, 0.8383936F}},
    {{-7.1, 12.3, 0.45},
     -0.2120981F,
     -0.1353409F,
     0.6681893F,
     -0.0526001F,
     {0.8579147F, 0.8579147F, 0.8848935F}},
    {{255.7, -256.2, 511.9},
     -0.2794642F,
     -0.3259501F,
     0.4964222F,
     -0.1086326F,
     {0.8693331F, 0.8693331F, 0.8991664F}},
    {{-0.02, 0.9, -100.6},
     -0.1043965F,
     -0.2422621F,
     0.3782708F,
     -0.04857282F,
     {4.059887F, 3.859154F, 3.984059F}},
    {{31.6, 77.7, -5.3},
     0.1165451F,
     0.4288887F,
     0.6480577F,
     0.2502588F,
     {0.8699846F, 0.8699846F, 0.8999809F}},
}};

/// Whether there is a dot at u = -2.99 + i / 8 and v = -0.98 + j / 4, in column i of row j.
constexpr std::array<std::string_view, 16> pbrt_dots = {
    "..............#####..........######...#####.....",
    "...............###.............###....#####.....",
    "................................................",
    "................................................",
    "................................................",
    "................................................",
    "................................................",
    "##....................#####.....................",
    "###...................#####.....................",
    "#.......................#.......................",
    "................................................",
    "..............####....#####....####....####...##",
    ".............######...#####....#####..######..##",
    "..............####.....###.....####....####....#",
    "................................................",
    ".......................####...#####...#####...##",
};

void check_close(double value, double expected, double tolerance) {
    INFO(value << " for " << expected);
    CHECK(std::abs(value - expected) < tolerance);
}

void check_close(const Color& value, const Color& expected, double tolerance) {
    for (int i = 0; i < 3; ++i) check_close(value[i], expected[i], tolerance);
}

}  // namespace

TEST_CASE("noise and its sums have pbrt-v3's values", "[texture]") {
    for (const PbrtValues& v : pbrt_values) {
        INFO(v.position.x << " " << v.position.y << " " << v.position.z);
        check_close(gradient_noise(v.position), v.noise, 1e-4);
        check_close(procedural_value(FbmTexture{}, v.position), v.fbm, 2e-4);
        check_close(procedural_value(WrinkledTexture{{}, {4, 0.7F}}, v.position), v.wrinkled, 2e-4);
        check_close(procedural_value(WindyTexture{}, v.position), v.windy, 1e-4);
    }
}

TEST_CASE("marble has pbrt-v3's colours, above 1 where its curve is continued", "[texture]") {
    const MarbleTexture marble{{}, {}, 2, 10};
    for (const PbrtValues& v : pbrt_values) {
        INFO(v.position.x << " " << v.position.y << " " << v.position.z);
        check_close(procedural_value(marble, v.position), v.marble, 5e-3);
    }
}

TEST_CASE("dots are where pbrt-v3's are", "[texture]") {
    for (std::size_t j = 0; j < pbrt_dots.size(); ++j) {
        std::string row;
        for (std::size_t i = 0; i < pbrt_dots[j].size(); ++i) {
            const Vec2 st(-2.99 + double(i) / 8, -0.98 + double(j) / 4);
            row += is_in_dot(st) ? '#' : '.';
        }
        CHECK(row == pbrt_dots[j]);
    }
}

TEST_CASE("a procedural texture is evaluated where its map takes the point", "[texture]") {
    const Affine map{{0, 2, 0}, {0, 0, 2}, {2, 0, 0}, {1, 2, 3}};
    const Vec3 p(0.3, -0.4, 0.9), mapped = map.point(p);
    CHECK(procedural_value(FbmTexture{map, {}}, p) == procedural_value(FbmTexture{}, mapped));
    CHECK(procedural_value(WrinkledTexture{map, {}}, p) ==
          procedural_value(WrinkledTexture{}, mapped));
    CHECK(procedural_value(WindyTexture{map}, p) == procedural_value(WindyTexture{}, mapped));
    CHECK(procedural_value(MarbleTexture{map, {}}, p) == procedural_value(MarbleTexture{}, mapped));
}

TEST_CASE("noise is 0 at whole numbers and repeats after 256 of them", "[texture]") {
    CHECK(gradient_noise({-3, 7, 1000}) == 0);
    CHECK(gradient_noise({1e300, -1e300, 0.25}) == gradient_noise({0, 0, 0.25}));
    CHECK(gradient_noise({0.25 - 256, 0.5 + 512, 0.75}) == gradient_noise({0.25, 0.5, 0.75}));
    CHECK(gradient_noise({std::numeric_limits<double>::infinity(), 0.5, 0.5}) == 0);
}

TEST_CASE("a sum without octaves is 0, or the mean of the first that is left out", "[texture]") {
    for (const int octaves : {0, -5}) {
        CHECK(procedural_value(FbmTexture{{}, {octaves, 0.5F}}, Vec3(0.4)) == 0);
        CHECK(procedural_value(WrinkledTexture{{}, {octaves, 0.5F}}, Vec3(0.4)) == 0.2F);
    }
}

TEST_CASE("any number of octaves ends soon", "[texture]") {
    const FractalNoise many{2000000000, 0.5F}, most{60, 0.5F};
    CHECK(procedural_value(FbmTexture{{}, many}, Vec3(0.4)) ==
          procedural_value(FbmTexture{{}, most}, Vec3(0.4)));
}
