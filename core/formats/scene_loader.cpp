#include "core/formats/scene_loader.h"

namespace etalon {
namespace {

void settle_cameras(const SceneLoader& loader, DiagnosticLog& log) {
    const std::optional<UnusableCamera>& bad = loader.unusable_camera;
    if (bad && loader.has_camera) {
        log.warn(bad->offset, "camera", "{}; this camera is left out", bad->why);
    } else if (bad) {
        log.error(bad->offset, "camera", "{}, so nothing can be rendered", bad->why);
    } else if (!loader.has_camera) {
        log.error(loader.in.tokens().offset(), "camera", "no camera, so nothing can be rendered");
    }
}

}  // namespace

void SceneLoader::set_material(const Material& m) {
    material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(m);
}

std::uint32_t SceneLoader::current_material() {
    if (!material) {
        in.warn("no-material", "'{}' before any material; it gets a default one", in.keyword());
        set_material(default_material);
    }
    return *material;
}

Sides SceneLoader::sides() {
    const bool opaque = scene.materials[current_material()].transmission == Color(0.0F);
    return options.one_sided && opaque ? Sides::front : Sides::both;
}

LoadResult SceneLoader::finish(DiagnosticLog& log) {
    settle_cameras(*this, log);
    LoadResult result;
    if (!log.has_errors()) result.scene = std::move(scene);
    result.diagnostics = log.take();
    return result;
}

void read_background(SceneLoader& loader) {
    const Color color = loader.in.color("colour");
    if (loader.in.ok()) loader.scene.environment.background = color;
}

}  // namespace etalon
