// Scenes of instances, as etalon-scenes writes them, and the same scenes flattened.
#include <stdexcept>

#include "bench/scenes/bench_families.h"
#include "bench/scenes/flattened.h"
#include "core/formats/load.h"
#include "scenes/generate/scene_text.h"

namespace etalon::bench {
namespace {

Scene generated(const std::string& family, std::size_t size) {
    LoadResult loaded =
        load_scene_text(generate::scene_text(family, static_cast<std::int64_t>(size)), family);
    if (!loaded.scene) throw std::runtime_error(report(loaded.diagnostics));
    return std::move(*loaded.scene);
}

Scene without_instances(Scene scene) {
    scene.geometry = flattened(scene.geometry);
    return scene;
}

}  // namespace

Scene forest(std::size_t instances) {
    return generated("forest", instances);
}

Scene forest_copies(std::size_t instances) {
    return without_instances(forest(instances));
}

Scene plaza(std::size_t instances) {
    return generated("plaza", instances);
}

Scene plaza_copies(std::size_t instances) {
    return without_instances(plaza(instances));
}

}  // namespace etalon::bench
