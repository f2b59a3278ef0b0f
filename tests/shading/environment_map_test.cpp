// Lazy reading of a skybox's images, and the treatment of damaged ones.
#include "core/shading/environment_map.h"

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

/// Returns a skybox of large faces, each of one colour.
Environment skybox_in(const TemporaryFolder& folder, const std::string& extension) {
    Environment environment{background, Skybox{}};
    for (std::size_t k = 0; k < towards.size(); ++k) {
        const std::string path = folder / (std::to_string(k) + extension);
        const RenderedImage image{
            64, 64, {{0, 0}, {63, 63}}, std::vector<Color>(64 * 64, color_of(k)), false, {}};
        REQUIRE(write_image(path, image) == "");
        environment.skybox->faces[k] = path;
    }
    return environment;
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
    const EnvironmentMap map(environment, problems);
    CHECK(problems.empty());
    CHECK(map.radiance(towards[1]) == color_of(1));
    for (const std::string& path : environment.skybox->faces) std::filesystem::remove(path);
    CHECK(map.radiance(towards[1]) == color_of(1));
    CHECK(map.late_problems().empty());
    CHECK(map.radiance(towards[2]) == background);
    CHECK(map.late_problems().size() == 1);
}

TEST_CASE("threads that hit a face at the same time use the same image") {
    const TemporaryFolder folder;
    const Environment environment = skybox_in(folder, ".exr");
    for (int i = 0; i < 20; ++i) {
        std::vector<std::string> problems;
        const EnvironmentMap map(environment, problems);
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
    const EnvironmentMap map(environment, problems);
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Matchers::StartsWith(path + ": cannot be read: "));
    for (const Vec3& direction : towards) CHECK(map.radiance(direction) == background);
    CHECK(map.late_problems().empty());
}

TEST_CASE("a face whose pixels turn out damaged is the background, and the others are not") {
    const TemporaryFolder folder;
    Environment environment = skybox_in(folder, GENERATE(".exr", ".png"));
    environment.skybox->nearest = GENERATE(false, true);
    const std::string& path = environment.skybox->faces[3];
    cut(path);
    std::vector<std::string> problems;
    const EnvironmentMap map(environment, problems);
    CHECK(problems.empty());
    for (std::size_t k = 0; k < towards.size(); ++k) {
        const bool whole = k != 3;
        CHECK((map.radiance(towards[k]) == background) == !whole);
    }
    REQUIRE(map.late_problems().size() == 1);
    CHECK_THAT(map.late_problems()[0], Catch::Matchers::StartsWith(path + ": cannot be read: "));
}
