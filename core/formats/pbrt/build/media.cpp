// Media of a frame, in its order.
#include "core/formats/pbrt/build/scattering_values.h"

namespace etalon::pbrt {
namespace {

/// Returns a coefficient: the file's, else the preset's, else the default, times the scale.
Color coefficient(SceneBuilder& b, const Plugin& medium, std::string_view name,
                  const std::array<float, 3>* preset) {
    const Parameters& p = medium.parameters;
    const Color given = preset && !p.is_given(name) ? color_of(*preset) : p.color(name);
    const Color scaled = given * p.number("scale");
    const Color positive(std::max(scaled.x, 0.0F), std::max(scaled.y, 0.0F),
                         std::max(scaled.z, 0.0F));
    if (!etalon::is_finite(scaled)) {
        b.warn(medium.where, "medium", "'{}' is infinite; taken as 0", name);
        return Color(0.0F);
    }
    if (positive != scaled) {
        b.warn(medium.where, "medium", "'{}' is below 0, where it is taken as 0", name);
    }
    return positive;
}

/// Returns the grid's densities. Nothing, and a warning, if its box has no volume.
std::optional<DensityGrid> grid_of(SceneBuilder& b, const Medium& medium) {
    const Parameters& p = medium.plugin.parameters;
    const std::optional<Affine> to_world = b.affine(medium.to_world, medium.plugin.where);
    if (!to_world) return std::nullopt;
    const Vec3 corner(p.vector("p0")), size = Vec3(p.vector("p1")) - corner;
    const Affine box = *to_world * Affine{{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}, corner};
    if (!(std::abs(box.determinant()) > 0) || !etalon::is_finite(inverse(box))) {
        b.warn(medium.plugin.where, "medium", "the medium is left out: its box has no volume");
        return std::nullopt;
    }
    const std::span<const float> densities = p.numbers("density");
    DensityGrid grid{{p.integer("nx"), p.integer("ny"), p.integer("nz")}, {}, inverse(box)};
    grid.densities.reserve(densities.size());
    for (const float density : densities) grid.densities.push_back(std::max(density, 0.0F));
    return grid;
}

PhysicalMedium build_medium(SceneBuilder& b, const Medium& medium) {
    const Plugin& plugin = medium.plugin;
    const ScatteringPreset* const preset = preset_of(b, plugin, "preset");
    PhysicalMedium built{coefficient(b, plugin, "sigma_a", preset ? &preset->absorption : nullptr),
                         coefficient(b, plugin, "sigma_s", preset ? &preset->scattering : nullptr),
                         mean_cosine(b, plugin)};
    if (plugin.type->name == "homogeneous") return built;
    built.grid = grid_of(b, medium);
    return built.grid ? built : PhysicalMedium{Color(0.0F), Color(0.0F)};
}

/// Warns if the integrator ignores the media that are used: at the statement that chooses it, or at
/// the first medium if the file does not.
void warn_of_media(SceneBuilder& b) {
    const bool is_files = b.integrator.empty();
    const Plugin& files = b.frame.integrator;
    const std::string_view renderer = is_files ? b.result.settings.integrator : b.integrator;
    if (!b.frame.has_media || renderer == "volpath") return;
    const bool is_at_integrator = is_files || b.frame.media.empty();
    b.warn(is_at_integrator ? files.where : b.frame.media.front().plugin.where, "media",
           "integrator \"{}\" leaves out media, as in pbrt-v3; \"volpath\" renders them",
           is_files ? files.type->name : b.integrator);
}

}  // namespace

void build_media(SceneBuilder& b) {
    for (const Medium& medium : b.frame.media) {
        b.look().media.push_back(build_medium(b, medium));
    }
    b.look().camera_medium = b.frame.camera_medium;
    warn_of_media(b);
}

}  // namespace etalon::pbrt
