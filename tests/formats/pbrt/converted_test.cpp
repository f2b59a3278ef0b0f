// Conversion of scenes of other formats.
#include "core/formats/load.h"
#include "core/formats/write/write.h"
#include "tests/formats/pbrt/pbrt_text.h"
#include "tests/formats/whole_scenes.h"

using namespace etalon;
using namespace etalon::pbrt;

TEST_CASE("a scene of another format is written as PBRT without fault") {
    for (const WholeScene& scene : whole_scenes()) {
        CAPTURE(scene.format);
        LoadOptions options;
        options.format = scene.format;
        const LoadResult loaded = load_scene_text(scene.text, "a", options);
        REQUIRE(loaded.scene);
        if (loaded.scene->is_physical()) continue;
        const std::string text = write_pbrt(*loaded.scene, loaded.settings, "").text;
        const ParsedFile file = parse_text(text);
        CHECK(messages(file) == Messages{});
        REQUIRE(file.frames.size() == 1);
        CHECK_FALSE(file.frames[0].shapes.empty());
    }
}
