#include "core/formats/nff/nff.h"

#include "core/formats/camera_block.h"
#include "core/formats/scene_loader.h"
#include "core/formats/statements.h"

namespace etalon {
namespace {

void read_view(SceneLoader& loader) {
    read_camera_block(loader, CameraDialect::nff);
}

/// Reads a light, which may have a colour.
void read_light(SceneLoader& loader) {
    Reader& in = loader.in;
    const Vec3 position = in.vector("position");
    if (in.ok() && !in.tokens().at_number()) return loader.add_light(position);
    const Color color = in.color("colour");
    if (in.ok()) loader.scene.whitted().lights.emplace_back(PointLight{position, color});
}

/// Reads f r g b Kd Ks Shine T ior. Opaque surfaces may have any index of refraction, even 0.
void read_fill(SceneLoader& loader) {
    Reader& in = loader.in;
    const Color color = in.color("colour");
    const auto weight = [&](std::string_view what) { return static_cast<float>(in.number(what)); };
    const float kd = weight("Kd"), ks = weight("Ks");
    Material m;
    m.diffuse = color * kd;
    m.specular = m.reflection = Color(ks);
    m.shininess = in.number("Shine");
    m.highlight = Highlight::phong;
    m.transmission = Color(weight("T"));
    const double ior = in.number("index of refraction");
    if (m.transmission != Color(0.0F)) m.ior = ior;
    if (in.ok()) loader.set_material(m);
}

using Entry = Keyword<SceneLoader>;

constexpr std::array keywords = {
    Entry{"p", read_polygon}, Entry{"pp", read_patch},     Entry{"s", read_sphere},
    Entry{"c", read_cone},    Entry{"f", read_fill},       Entry{"l", read_light},
    Entry{"v", read_view},    Entry{"b", read_background},
};

constexpr auto names = names_of(keywords);

}  // namespace

LoadResult load_nff(std::string_view text, const std::string& path, const LoadOptions& options) {
    DiagnosticLog log(path, text, options.strict);
    SceneLoader loader{Reader(text, log, names), options,
                       std::filesystem::path(path).parent_path()};
    loader.settings.display_colors = true;
    read_statements(loader, keywords);
    return loader.finish(log);
}

}  // namespace etalon
