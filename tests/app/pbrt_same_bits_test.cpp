// Renders real PBRT scenes, if this machine has them, with every exact backend and several threads.
#include <filesystem>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/formats/shared_scenes.h"

using namespace etalon::test;

namespace {

/// Scenes with all kinds of lights, cameras, materials, textures and meshes that are rendered.
constexpr const char* scenes[] = {"killeroo/killeroo-simple",
                                  "cornell-box/scene",
                                  "teapot/teapot-area-light",
                                  "features/cameras/depth-of-field",
                                  "features/lights/goniometric",
                                  "features/lights/infinite-no-map",
                                  "features/materials/bump",
                                  "features/shapes/all-shapes",
                                  "features/shapes/triangles-alpha-mask",
                                  "features/textures/marble"};

/// The pixels of the image of a scene.
std::vector<float> rendered(const Folder& f, const std::string& scene, const std::string& options) {
    const auto r =
        f.etalon("render '" + scene + "' --resolution 60x40 --spp 1 --quiet -o a.exr " + options);
    INFO(r.err);
    REQUIRE(r.status == 0);
    const auto read = etalon::read_image(f.path("a.exr"));
    REQUIRE(read);
    return std::get<std::vector<float>>(read.value.pixels);
}

}  // namespace

TEST_CASE("ten real PBRT scenes have the same bits by every exact backend on 1, 2 and 3 threads",
          "[needs_shared_scenes]") {
    const auto path = [](const std::string& name) { return etalon::shared_scene("pbrt", name); };
    SKIP_UNLESS(std::filesystem::exists(path(scenes[0])),
                "no PBRT scenes in " << etalon::shared_scenes_folder());
    const Folder f;
    for (const char* name : scenes) {
        CAPTURE(name);
        const std::vector<float> expected = rendered(f, path(name), "-b grid --threads 1");
        for (const char* options : {"-b bvh --threads 2", "-b embree --threads 3",
                                    "-b embree-user --threads 1", "-b grid --threads 3"}) {
            CAPTURE(options);
            CHECK(rendered(f, path(name), options) == expected);
        }
    }
}
