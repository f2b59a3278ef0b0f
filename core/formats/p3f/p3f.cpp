#include "core/formats/p3f/p3f.h"

#include "core/formats/camera_block.h"
#include "core/formats/p3f/p3f_loader.h"
#include "core/formats/statements.h"

namespace etalon {
namespace {

void read_camera(SceneLoader& loader) {
    read_camera_block(loader, CameraDialect::p3f);
}

/// Skips a statement that a single repository of the course has added.
void skip_private_extension(SceneLoader& loader) {
    loader.in.warn("extension", "'{}' is a private extension of one program; it is left out",
                   loader.in.keyword());
    loader.in.skip_to_keyword();
}

using Entry = Keyword<SceneLoader>;

// To add a statement: its reader in the fitting file of this folder, declared in p3f_loader.h, and
// a line here.
constexpr std::array keywords = {
    Entry{"s", read_sphere},
    Entry{"p", read_polygon},
    Entry{"pp", read_patch},
    Entry{"mat", p3f::read_mat},
    Entry{"f", p3f::read_f},
    Entry{"box", p3f::read_box},
    Entry{"c", read_cone},
    Entry{"mesh", p3f::read_mesh},
    Entry{"pl", p3f::read_plane},
    Entry{"npl", p3f::read_hessian_plane},
    Entry{"light", p3f::read_light},
    Entry{"l", p3f::read_point_light},
    Entry{"camera", read_camera},
    Entry{"v", read_camera},
    Entry{"bclr", read_background},
    Entry{"env", p3f::read_environment},
    Entry{"accel", p3f::read_accel},
    Entry{"spp", p3f::read_samples},
    Entry{"sm", skip_private_extension, false},
    Entry{"ms", skip_private_extension, false},
    Entry{"a", skip_private_extension, false},
    Entry{"al", skip_private_extension, false},
    Entry{"fire", skip_private_extension, false},
};

constexpr auto names = names_of(keywords);

/// Applies the rules of the course's programs of 2021.
void apply_legacy(Scene& scene, RenderSettings& settings) {
    settings.max_depth = 6;
    settings.whitted.fixed_bias = 1e-3;
    settings.whitted.schlick = true;
    settings.whitted.clamp_each_ray = true;
    if (scene.whitted().environment.skybox) scene.whitted().environment.skybox->nearest = true;
    if (scene.whitted().lights.empty()) return;
    const float share = 1 / (1.25F * static_cast<float>(scene.whitted().lights.size()));
    for (Material& m : scene.whitted().materials) m.specular *= share;
}

}  // namespace

LoadResult load_p3f(std::string_view text, const std::string& path, const LoadOptions& options) {
    DiagnosticLog log(path, text, options.strict);
    SceneLoader loader{Reader(text, log, names), options, std::filesystem::path(path).parent_path(),
                       p3f::default_material()};
    loader.settings.display_colors = true;
    read_statements(loader, keywords);
    if (options.legacy) apply_legacy(loader.scene, loader.settings);
    return loader.finish(log);
}

}  // namespace etalon
