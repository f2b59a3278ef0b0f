// Small scenes of PBRT statements.
#pragma once

#include "core/formats/load.h"
#include "core/shading/textured_cut_outs.h"
#include "tests/catch.h"
#include "tests/render/test_scenes.h"

namespace etalon::test {

/// Returns a scene of PBRT statements, 8 x 8 pixels through a narrow camera at (0, 0, -5) that
/// looks along z. `options` may replace the integrator and the samples.
inline TestScene pbrt_scene(const std::string& world, const std::string& options = "") {
    const std::string text =
        "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 4\n"
        "Film \"image\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
        "Sampler \"sobol\" \"integer pixelsamples\" 64\n" +
        options + "\nWorldBegin\n" + world + "\nWorldEnd\n";
    LoadResult loaded = load_scene_text(text, "test.pbrt");
    INFO(report(loaded.diagnostics));
    REQUIRE(loaded.scene);
    REQUIRE(loaded.diagnostics.empty());
    std::vector<std::string> problems;
    make_cut_outs(*loaded.scene, problems);
    REQUIRE(problems.empty());
    TestScene scene;
    static_cast<Scene&>(scene) = std::move(*loaded.scene);
    scene.settings = loaded.settings;
    return scene;
}

}  // namespace etalon::test
