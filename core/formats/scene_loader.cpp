#include "core/formats/scene_loader.h"

#include <algorithm>
#include <cmath>

#include "core/formats/expected_growth.h"

namespace etalon {
namespace {

void finalize_cameras(const SceneLoader& loader, DiagnosticLog& log) {
    const std::optional<UnusableCamera>& bad = loader.unusable_camera;
    if (bad && loader.has_camera) {
        log.warn(bad->offset, "camera", "{}; this camera is left out", bad->why);
    } else if (bad) {
        log.error(bad->offset, "camera", "{}, so nothing can be rendered", bad->why);
    } else if (!loader.has_camera) {
        log.error(loader.in.tokens().offset(), "camera", "no camera, so nothing can be rendered");
    }
}

/// Returns whether a material is possible; if not, reports why.
bool is_possible(Reader& in, const Material& m) {
    if (m.transmission != Color(0.0F) && !(m.ior > 0)) {
        in.warn("material", "the index of refraction of glass is {}; expected more than 0", m.ior);
    } else if (m.shininess < 0) {
        in.warn("material", "the Shine is {}; expected 0 or more", m.shininess);
    } else if (!is_finite(m.diffuse) || !is_finite(m.specular) || !is_finite(m.reflection) ||
               !is_finite(m.transmission)) {
        in.warn("material", "a colour times its weight is too large for a colour");
    } else {
        return true;
    }
    return false;
}

}  // namespace

Material default_diffuse() {
    Material m;
    m.diffuse = Color(0.5F);
    return m;
}

bool SceneLoader::set_material(const Material& m) {
    if (!is_possible(in, m)) return false;
    material = static_cast<std::uint32_t>(scene.whitted().materials.size());
    scene.whitted().materials.push_back(m);
    return true;
}

std::uint32_t SceneLoader::current_material() {
    if (!material) {
        in.warn("no-material", "'{}' before any material; it gets a default one", in.keyword());
        set_material(default_material);
    }
    return *material;
}

Sides SceneLoader::sides() {
    const bool opaque = scene.whitted().materials[current_material()].transmission == Color(0.0F);
    return options.one_sided && opaque ? Sides::front : Sides::both;
}

void SceneLoader::add_light(const Vec3& position) {
    uncolored_lights.push_back(scene.whitted().lights.size());
    scene.whitted().lights.emplace_back(PointLight{position, Color(1.0F)});
}

void SceneLoader::look_ahead() {
    const std::size_t read = in.tokens().offset();
    const double whole =
        1 + static_cast<double>(in.tokens().remaining()) / static_cast<double>(read);
    constexpr std::size_t farthest = 32;  // a text may not continue as it began
    constexpr double margin = 0.02;       // lines differ in length
    if (whole > 2) {
        make_room_for_growth(scene.geometry, std::min<double>(whole, farthest) * (1 + margin));
    }
    looks_ahead_at = read * farthest;
}

LoadResult SceneLoader::finish(DiagnosticLog& log) {
    finalize_cameras(*this, log);
    const double intensity = 1 / std::sqrt(static_cast<double>(scene.whitted().lights.size()));
    for (const std::size_t i : uncolored_lights) {
        std::get<PointLight>(scene.whitted().lights[i]).color =
            Color(static_cast<float>(intensity));
    }
    LoadResult result;
    if (!log.has_errors()) result.scene = std::move(scene);
    result.settings = settings;
    result.diagnostics = log.take();
    return result;
}

void read_background(SceneLoader& loader) {
    const Color color = loader.in.color("colour");
    if (loader.in.ok()) loader.scene.whitted().environment.background = color;
}

}  // namespace etalon
