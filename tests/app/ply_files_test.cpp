// Many PLY files, which threads read ahead: the image and the order of diagnostics do not change.
#include <fmt/format.h>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

constexpr int files = 40;

std::string shape(int i) {
    return fmt::format("Shape \"plymesh\" \"string filename\" \"{}.ply\"\n", i);
}

std::string triangle(int i) {
    const double x = 0.1 * i - 2;
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "{} -1 {}\n{} 1 4\n{} 0 5\n3 0 1 2\n",
        x, 4 + i % 3, x + 0.3, x - 0.2);
}

/// Files of which every ninth is missing and every eleventh is damaged, used in the scene and, the
/// later ones, in objects. One object is built out of order, since its first instance is
/// degenerate.
void write_scene(const Folder& f) {
    std::string world, objects, instances;
    for (int i = 0; i < files; ++i) {
        if (i % 9 != 4) f.write(fmt::format("{}.ply", i), i % 11 == 7 ? "ply\n" : triangle(i));
        if (i < 30) {
            world += shape(i);
        } else {
            objects += fmt::format("ObjectBegin \"{0}\"\n{1}ObjectEnd\n", i, shape(i));
            if (i == 30)
                instances += "AttributeBegin Scale 0 1 1 ObjectInstance \"30\" AttributeEnd\n";
            instances += fmt::format("ObjectInstance \"{}\"\n", i == 30 ? 35 : i);
        }
    }
    f.write("scene.pbrt",
            "Film \"image\" \"integer xresolution\" 40 \"integer yresolution\" 20\nWorldBegin\n"
            "LightSource \"infinite\"\nMaterial \"matte\" \"rgb Kd\" [ .3 .5 .7 ]\n" +
                objects + world + instances + "ObjectInstance \"30\"\nWorldEnd\n");
}

}  // namespace

TEST_CASE("PLY files that are read ahead give the same image and ordered diagnostics", "[app]") {
    const Folder f;
    write_scene(f);
    std::string said;
    std::vector<float> picture;
    for (const int threads : {1, 2, 3}) {
        INFO(threads);
        const auto r =
            f.etalon(fmt::format("render scene.pbrt -q --spp 2 -o a.exr -t {}", threads));
        REQUIRE(r.status == 0);
        const auto image = etalon::read_image(f.path("a.exr"));
        REQUIRE(image.error == "");
        const auto& pixels = std::get<std::vector<float>>(image.value.pixels);
        if (threads == 1) said = r.err, picture = pixels;
        CHECK(r.err == said);
        CHECK(pixels == picture);
    }
    std::size_t at = 0;
    for (const char* name : {"4.ply", "7.ply", "13.ply", "18.ply", "22.ply", "29.ply", "31.ply"}) {
        INFO(name << " in\n" << said);
        const std::size_t found = said.find(fmt::format("left out: {}", name), at);
        REQUIRE(found != std::string::npos);
        at = found;
    }
}
