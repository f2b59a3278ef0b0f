// EXR files of Etalon as other programs read them.
#include <cstdio>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/random_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns what the command prints.
std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    if (!pipe) return text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    ::pclose(pipe);
    return text;
}

bool is_installed(const std::string& program) {
    return !output_of("command -v " + program).empty();
}

std::string crop_with_metadata(const TemporaryFolder& folder) {
    RenderedImage image = random_image(10, 8, {{3, 2}, {8, 5}});
    image.pixels.assign(image.pixels.size(), Color(0.25F, 0.5F, 2));
    Imath::M44f camera;
    camera[3][0] = 7.25F;
    image.metadata = {{"software", std::string("Etalon")},
                      {"samplesPerPixel", 64},
                      {"renderTimeSeconds", 1.25F},
                      {"worldToCamera", camera}};
    REQUIRE(write_image(folder / "p.exr", image) == "");
    return folder / "p.exr";
}

}  // namespace

TEST_CASE("exrheader sees the windows, the compression and the metadata", "[needs_exrheader]") {
    SKIP_UNLESS(is_installed("exrheader"), "exrheader is not installed");
    const TemporaryFolder folder;
    const std::string text = output_of("exrheader " + crop_with_metadata(folder));
    CHECK_THAT(text, ContainsSubstring("displayWindow (type box2i): (0 0) - (9 7)"));
    CHECK_THAT(text, ContainsSubstring("dataWindow (type box2i): (3 2) - (8 5)"));
    CHECK_THAT(text, ContainsSubstring("zip, multi-scanline blocks"));
    CHECK_THAT(text, ContainsSubstring("R, 32-bit floating-point"));
    CHECK_THAT(text, ContainsSubstring("software (type string): \"Etalon\""));
    CHECK_THAT(text, ContainsSubstring("samplesPerPixel (type int): 64"));
    CHECK_THAT(text, ContainsSubstring("renderTimeSeconds (type float): 1.25"));
    CHECK_THAT(text, ContainsSubstring("worldToCamera (type m44f)") && ContainsSubstring("7.25"));
    CHECK_THAT(text, ContainsSubstring("chromaticities (type chromaticities)"));
}

TEST_CASE("oiiotool sees the pixels, the windows and the metadata", "[needs_oiiotool]") {
    SKIP_UNLESS(is_installed("oiiotool"), "oiiotool is not installed");
    const TemporaryFolder folder;
    const std::string path = crop_with_metadata(folder);
    const std::string text = output_of("oiiotool --info -v --stats " + path);
    CHECK_THAT(text, ContainsSubstring("6 x    4, 3 channel, float openexr"));
    CHECK_THAT(text, ContainsSubstring("pixel data origin: x=3, y=2"));
    CHECK_THAT(text, ContainsSubstring("full/display size: 10 x 8"));
    CHECK_THAT(text, ContainsSubstring("Stats Avg: 0.250000 0.500000 2.000000"));
    CHECK_THAT(text, ContainsSubstring("oftware: \"Etalon\""));
    CHECK_THAT(text, ContainsSubstring("samplesPerPixel: 64"));
    CHECK_THAT(text, ContainsSubstring("amera: 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7.25, 0, 0, 1"));
}

TEST_CASE("oiiotool sees the channels beside the colours, and their types", "[needs_oiiotool]") {
    SKIP_UNLESS(is_installed("oiiotool"), "oiiotool is not installed");
    const TemporaryFolder folder;
    RenderedImage image = random_image(2, 1);
    image.pixels.assign(2, Color(0.0F));
    image.channels = {{"N.X", std::vector{0.5F, -0.5F}},
                      {"Z", std::vector{2.0F, 3.0F}},
                      {"primitiveId", std::vector{7U, 4294967295U}}};
    REQUIRE(write_image(folder / "p.exr", image) == "");
    const std::string text = output_of("oiiotool --info -v --stats " + (folder / "p.exr"));
    CHECK_THAT(text, ContainsSubstring("2 x    1, 6 channel"));
    CHECK_THAT(text, ContainsSubstring("primitiveId (uint)"));
    CHECK_THAT(text, ContainsSubstring("N.X (float)") && ContainsSubstring("Z (float)"));
}
