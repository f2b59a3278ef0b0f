// Lazy reading of a skybox's images, and the treatment of damaged ones.
#include "core/shading/environment_map.h"

#include <algorithm>

#include "core/color/srgb.h"
#include "core/image/io.h"
#include "core/parallel/parallel.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const Color background(0.1F, 0.2F, 0.3F);

/// A direction to each face, in the order of Skybox::faces.
const std::array<Vec3, 6> towards = {Vec3(-1, 0.1, 0), Vec3(1, 0.1, 0), Vec3(0, 1, 0.1),
                                     Vec3(0, -1, 0.1), Vec3(0.1, 0, 1), Vec3(0.1, 0, -1)};

Color color_of(std::size_t face) {
    return Color(static_cast<float>(face) + 1);
}

/// Returns a skybox of large faces, each of one colour, of light or of display values.
Environment skybox_in(const TemporaryFolder& folder, const std::string& extension,
                      bool displayed = false) {
    Environment environment{background, Skybox{}};
    for (std::size_t k = 0; k < towards.size(); ++k) {
        const std::string path = folder / (std::to_string(k) + extension);
        RenderedImage image{
            64, 64, {{0, 0}, {63, 63}}, std::vector<Color>(64 * 64, color_of(k)), displayed, {}};
        image.keep_display_values = displayed;
        REQUIRE(write_image(path, image) == "");
        environment.skybox->faces[k] = path;
    }
    return environment;
}

/// Number of texels along a side of a small face.
constexpr int small_size = 4;

Color texel(std::size_t face, int column, int row) {
    return Color(static_cast<float>(face), static_cast<float>(column), static_cast<float>(row));
}

/// Returns a skybox of small faces, each texel of which has a colour of its own.
Environment skybox_of_texels(const TemporaryFolder& folder) {
    Environment environment{background, Skybox{}};
    const Imath::Box2i window({0, 0}, {small_size - 1, small_size - 1});
    for (std::size_t k = 0; k < towards.size(); ++k) {
        RenderedImage image{small_size, small_size, window, {}, false, {}};
        for (int i = 0; i < small_size * small_size; ++i) {
            image.pixels.push_back(texel(k, i % small_size, i / small_size));
        }
        const std::string path = folder / (std::to_string(k) + ".exr");
        REQUIRE(write_image(path, image) == "");
        environment.skybox->faces[k] = path;
    }
    return environment;
}

/// Returns where the centre of a small face's texel, or a point between centres, looks, as
/// scenes/skybox/make.py draws it: s to the right and t upwards, seen from inside. +X is on the
/// left.
Vec3 towards_texel(std::size_t face, double column, double row) {
    const double s = (2 * column + 1.0) / small_size - 1, t = 1 - (2 * row + 1.0) / small_size;
    const std::array<Vec3, 6> directions = {Vec3(-1, t, -s), Vec3(1, t, s),  Vec3(-s, 1, -t),
                                            Vec3(-s, -1, t), Vec3(-s, t, 1), Vec3(s, t, -1)};
    return directions[face];
}

/// Checks which texel's colour is seen towards the centre of each: that of columns[column],
/// rows[row].
void check_texels(bool nearest, const std::array<int, small_size>& columns,
                  const std::array<int, small_size>& rows) {
    const TemporaryFolder folder;
    Environment environment = skybox_of_texels(folder);
    environment.skybox->nearest = nearest;
    std::vector<std::string> problems;
    const EnvironmentMap map(environment, Encoding::linear, problems);
    REQUIRE(problems.empty());
    for (std::size_t k = 0; k < towards.size(); ++k) {
        for (int row = 0; row < small_size; ++row) {
            for (int column = 0; column < small_size; ++column) {
                CAPTURE(k, column, row);
                const Color seen = map.radiance(towards_texel(k, column, row)),
                            expected = texel(k, columns[column], rows[row]);
                for (int c = 0; c < 3; ++c) CHECK(seen[c] == Approx(expected[c]).margin(1e-5));
            }
        }
    }
}

/// Keeps a file's header and loses its pixels.
void cut(const std::string& path) {
    const std::string content = content_of(path);
    put(path, std::string_view(content).substr(0, content.size() * 9 / 10));
}

}  // namespace

TEST_CASE("a face is read when a ray first hits it") {
    const TemporaryFolder folder;
    const Environment environment = skybox_in(folder, ".exr");
    std::vector<std::string> problems;
    const EnvironmentMap map(environment, Encoding::linear, problems);
    CHECK(problems.empty());
    CHECK(map.radiance(towards[1]) == color_of(1));
    for (const std::string& path : environment.skybox->faces) std::filesystem::remove(path);
    CHECK(map.radiance(towards[1]) == color_of(1));
    CHECK(map.late_problems().empty());
    CHECK(map.radiance(towards[2]) == background);
    CHECK(map.late_problems().size() == 1);
}

TEST_CASE("each texel of each face is seen where it is drawn") {
    check_texels(false, {0, 1, 2, 3}, {0, 1, 2, 3});
}

TEST_CASE("a face is interpolated between the centres of its texels, and even beyond the last") {
    const TemporaryFolder folder;
    std::vector<std::string> problems;
    const Environment environment = skybox_of_texels(folder);
    const EnvironmentMap map(environment, Encoding::linear, problems);
    REQUIRE(problems.empty());
    for (std::size_t k = 0; k < towards.size(); ++k) {
        for (const double column : {-0.4, 0.25, 1.5, 2.9, 3.4}) {
            const double row = 2.3 - column / 2;
            CAPTURE(k, column, row);
            const Color seen = map.radiance(towards_texel(k, column, row));
            CHECK(seen.x == Approx(k).margin(1e-5));
            CHECK(seen.y == Approx(std::clamp(column, 0.0, small_size - 1.0)).margin(1e-5));
            CHECK(seen.z == Approx(row).margin(1e-5));
        }
    }
}

TEST_CASE("the old programs' texel is the one before (size - 1) s and (size - 1) t") {
    // 3 (k + 1/2) / 4, rounded down: from the left, and from the lower edge.
    check_texels(true, {0, 1, 1, 2}, {1, 2, 2, 3});
}

TEST_CASE("a direction that is none sees the background") {
    const TemporaryFolder folder;
    Environment environment = skybox_in(folder, ".exr");
    environment.skybox->nearest = GENERATE(false, true);
    std::vector<std::string> problems;
    const EnvironmentMap map(environment, Encoding::linear, problems);
    constexpr double none = std::numeric_limits<double>::quiet_NaN(), most = infinity;
    for (const Vec3& d : {Vec3(none), Vec3(0, none, 1), Vec3(0), Vec3(0, -most, 1), Vec3(most)}) {
        CAPTURE(d);
        CHECK(map.radiance(d) == background);
    }
    CHECK(map.radiance(Vec3(1e-320, 0, 0)) == color_of(1));
    CHECK(map.radiance(Vec3(0, 1e308, -1e308)) == color_of(5));
}

TEST_CASE("threads that hit a face at the same time use the same image") {
    const TemporaryFolder folder;
    const Environment environment = skybox_in(folder, ".exr");
    for (int i = 0; i < 20; ++i) {
        std::vector<std::string> problems;
        const EnvironmentMap map(environment, Encoding::linear, problems);
        std::array<Color, 60> seen;
        parallel_for(seen.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) seen[k] = map.radiance(towards[k % 6]);
        });
        for (std::size_t k = 0; k < seen.size(); ++k) CHECK(seen[k] == color_of(k % 6));
    }
}

TEST_CASE("a skybox of which an image is missing or no image is the background from the start") {
    const TemporaryFolder folder;
    const Environment environment = skybox_in(folder, ".png");
    const std::string& path = environment.skybox->faces[3];
    SECTION("missing") {
        std::filesystem::remove(path);
    }
    SECTION("no image") {
        put(path, "This is no picture.\n");
    }
    std::vector<std::string> problems;
    const EnvironmentMap map(environment, Encoding::linear, problems);
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Matchers::StartsWith(path + ": cannot be read: "));
    for (const Vec3& direction : towards) CHECK(map.radiance(direction) == background);
    CHECK(map.late_problems().empty());
}

TEST_CASE("a face whose pixels turn out damaged is the background, and the others are not") {
    const TemporaryFolder folder;
    Environment environment = skybox_in(folder, GENERATE(".exr", ".png"));
    environment.skybox->nearest = GENERATE(false, true);
    const Encoding values = GENERATE(Encoding::linear, Encoding::display);
    const std::string& path = environment.skybox->faces[3];
    cut(path);
    std::vector<std::string> problems;
    const EnvironmentMap map(environment, values, problems);
    CHECK(problems.empty());
    for (std::size_t k = 0; k < towards.size(); ++k) {
        const bool whole = k != 3;
        CHECK((map.radiance(towards[k]) == background) == !whole);
    }
    REQUIRE(map.late_problems().size() == 1);
    CHECK_THAT(map.late_problems()[0], Catch::Matchers::StartsWith(path + ": cannot be read: "));
}

TEST_CASE("faces of light or of display values give the radiance as what is asked for") {
    const TemporaryFolder folder;
    const bool displayed = GENERATE(false, true);
    Environment environment = skybox_in(folder, ".exr", displayed);
    environment.skybox->nearest = GENERATE(false, true);
    std::vector<std::string> problems;
    const EnvironmentMap light(environment, Encoding::linear, problems);
    const EnvironmentMap display(environment, Encoding::display, problems);
    for (std::size_t k = 0; k < towards.size(); ++k) {
        const double stored = color_of(k).x;
        const double shone = displayed ? srgb_decoded(stored) : stored;
        const double shown = displayed ? stored : srgb_encoded(stored);
        CHECK(light.radiance(towards[k]).x == Approx(shone).epsilon(1e-6));
        CHECK(display.radiance(towards[k]).x == Approx(shown).epsilon(1e-6));
    }
}
