// Scenes with instances and all of PBRT's shapes: the same bits with every exact backend and number
// of threads, and when scaled by a power of two.
#include <filesystem>

#include "core/formats/load.h"
#include "core/parallel/parallel.h"
#include "core/scene/transformed.h"
#include "core/shading/textured_cut_outs.h"
#include "scenes/generate/scene_text.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

namespace fs = std::filesystem;

struct NamedScene {
    std::string name;
    LoadResult loaded;
};

std::vector<NamedScene> scenes() {
    const fs::path source = ETALON_SOURCE_DIR;
    std::vector<NamedScene> list;
    for (const auto& entry : fs::directory_iterator(source / "tests/render/references")) {
        if (entry.path().extension() != ".pbrt") continue;
        list.push_back({entry.path().stem().string(), load_scene(entry.path().string())});
    }
    for (const char* name : {"curves", "cut_outs", "lights", "shapes"}) {
        const fs::path path = source / "scenes/pbrt" / (std::string(name) + ".pbrt");
        list.push_back({name, load_scene(path.string())});
    }
    for (const char* family : {"forest", "plaza"}) {
        list.push_back({family, load_scene_text(generate::scene_text(family, 300), family)});
    }
    return list;
}

std::vector<Color> pixels(const Scene& scene, const RenderSettings& settings,
                          std::string_view backend, int threads) {
    const ThreadLimit limit(threads);
    return render_with(scene, *find_backend(backend), settings).film.pixels();
}

}  // namespace

TEST_CASE("Scenes of instances and of every shape have the same bits by every exact backend") {
    std::size_t with_instances = 0, all = 0;
    for (NamedScene& named : scenes()) {
        CAPTURE(named.name);
        REQUIRE(named.loaded.scene);
        std::vector<std::string> problems;
        make_cut_outs(*named.loaded.scene, problems);
        REQUIRE(problems.empty());
        const Scene& scene = *named.loaded.scene;
        RenderSettings& settings = named.loaded.settings;
        settings.resolution = {36, 24};
        settings.samples_per_pixel = 2;
        const std::vector<Color> expected = pixels(scene, settings, "grid", 1);
        CHECK(std::ranges::any_of(expected, [](const Color& c) { return c.x > 0; }));
        CHECK(pixels(scene, settings, "bvh", 2) == expected);
        CHECK(pixels(scene, settings, "embree", 3) == expected);
        CHECK(pixels(scene, settings, "embree-user", 1) == expected);
        CHECK(pixels(scene, settings, "grid", 3) == expected);
        CHECK(pixels(transformed(scene, 0x1p-9), settings, "bvh", 1) == expected);
        CHECK(pixels(transformed(scene, 0x1p7), settings, "embree", 1) == expected);
        with_instances += scene.geometry.instances.empty() ? 0 : 1;
        ++all;
    }
    CHECK(with_instances >= 4);
    CHECK(all >= 12);
}
