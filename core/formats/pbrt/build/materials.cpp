// Materials of a frame, each by one line of a table.
#include <array>

#include "core/bsdf/lobe_list.h"
#include "core/formats/pbrt/build/scattering_values.h"
#include "core/scene/most_lobes.h"

namespace etalon::pbrt {
namespace {

using Kind = decltype(PhysicalMaterial::kind);

/// Returns the roughness along u and v from the parameters of these names; if they are not given,
/// from the third.
Roughness roughness(SceneBuilder& b, const Parameters& p, std::string_view u, std::string_view v,
                    std::string_view both = {}) {
    const auto one = [&](std::string_view name) {
        return b.number(p, both.empty() || p.is_given(name) ? name : both);
    };
    return {one(u), one(v), p.flag("remaproughness")};
}

Roughness same_roughness(SceneBuilder& b, const Parameters& p) {
    return roughness(b, p, "roughness", "roughness");
}

Kind matte(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return MatteMaterial{b.color(p, "Kd"), b.number(p, "sigma")};
}

Kind plastic(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return PlasticMaterial{b.color(p, "Kd"), b.color(p, "Ks"), same_roughness(b, p)};
}

Kind translucent(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return TranslucentMaterial{b.color(p, "Kd"), b.color(p, "Ks"), b.color(p, "reflect"),
                               b.color(p, "transmit"), same_roughness(b, p)};
}

GlassMaterial boundary(SceneBuilder& b, const Parameters& p) {
    return {b.color(p, "Kr"), b.color(p, "Kt"), b.number(p, "eta"),
            roughness(b, p, "uroughness", "vroughness")};
}

Kind glass(SceneBuilder& b, const Material& m) {
    return boundary(b, m.plugin.parameters);
}

Kind mirror(SceneBuilder& b, const Material& m) {
    return MirrorMaterial{b.color(m.plugin.parameters, "Kr")};
}

Kind metal(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return MetalMaterial{b.color(p, "eta"), b.color(p, "k"),
                         roughness(b, p, "uroughness", "vroughness", "roughness")};
}

Kind substrate(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return SubstrateMaterial{b.color(p, "Kd"), b.color(p, "Ks"),
                             roughness(b, p, "uroughness", "vroughness")};
}

Kind uber(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    const char* const along_u = p.is_given("uroughness") ? "uroughness" : "roughness";
    return UberMaterial{b.color(p, "Kd"),
                        b.color(p, "Ks"),
                        b.color(p, "Kr"),
                        b.color(p, "Kt"),
                        b.color(p, "opacity"),
                        b.number(p, "eta"),
                        roughness(b, p, along_u, "vroughness", along_u)};
}

Kind disney(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return DisneyMaterial{b.color(p, "color"),          b.number(p, "metallic"),
                          b.number(p, "eta"),           b.number(p, "roughness"),
                          b.number(p, "speculartint"),  b.number(p, "anisotropic"),
                          b.number(p, "sheen"),         b.number(p, "sheentint"),
                          b.number(p, "clearcoat"),     b.number(p, "clearcoatgloss"),
                          b.number(p, "spectrans"),     b.number(p, "flatness"),
                          b.number(p, "difftrans"),     p.flag("thin"),
                          b.color(p, "scatterdistance")};
}

Kind subsurface(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    SubsurfaceMaterial built{boundary(b, p), b.color(p, "sigma_a"), b.color(p, "sigma_s"),
                             mean_cosine(b, m.plugin), p.number("scale")};
    if (const ScatteringPreset* const preset = preset_of(b, m.plugin, "name")) {
        built.g = 0;  // the preset's scattering coefficient is the reduced one
        if (!p.is_given("sigma_a")) built.absorption = {color_of(preset->absorption)};
        if (!p.is_given("sigma_s")) built.scattering = {color_of(preset->scattering)};
    }
    return built;
}

Kind kd_subsurface(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return KdSubsurfaceMaterial{boundary(b, p), b.color(p, "Kd"), b.color(p, "mfp"),
                                mean_cosine(b, m.plugin), p.number("scale")};
}

/// Warns of hair parameters that others make ineffective.
void warn_of_ignored(SceneBuilder& b, const Plugin& hair, std::string_view by,
                     std::initializer_list<std::string_view> ignored) {
    for (const std::string_view name : ignored) {
        if (!hair.parameters.is_given(name)) continue;
        b.warn(hair.where, "ignored", "\"{}\" has no effect beside \"{}\"", name, by);
    }
}

Kind hair(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    HairMaterial hair;
    hair.eta = b.number(p, "eta");
    hair.beta_m = b.number(p, "beta_m");
    hair.beta_n = b.number(p, "beta_n");
    hair.alpha = b.number(p, "alpha");
    if (p.is_given("sigma_a")) {
        warn_of_ignored(b, m.plugin, "sigma_a", {"color", "eumelanin", "pheomelanin"});
        hair.pigment = HairPigment::absorption;
        hair.color = b.color(p, "sigma_a");
    } else if (p.is_given("color")) {
        warn_of_ignored(b, m.plugin, "color", {"eumelanin", "pheomelanin"});
        hair.pigment = HairPigment::reflectance;
        hair.color = b.color(p, "color");
    } else if (p.is_given("eumelanin") || p.is_given("pheomelanin")) {
        hair.eumelanin = b.number(p, "eumelanin");
        hair.pheomelanin = b.number(p, "pheomelanin");
    } else {
        hair.eumelanin = {1.3F};
    }
    return hair;
}

Kind fourier(SceneBuilder& b, const Material& m) {
    const BsdfFiles::Table& table =
        b.bsdf_files.read(std::string(m.plugin.parameters.string("bsdffile")));
    if (!table) b.warn(m.plugin.where, "bsdf", "{}; the surface is black", table.error);
    return FourierMaterial{table.value};
}

Kind mix(SceneBuilder& b, const Material& m) {
    return MixedMaterial{m.mixed[0], m.mixed[1], b.color(m.plugin.parameters, "amount")};
}

Kind no_surface(SceneBuilder&, const Material&) {
    return NoMaterial{};
}

struct Entry {
    std::string_view name;
    Kind (*build)(SceneBuilder&, const Material&);
};

// To add a material: a function above and a line here.
constexpr std::array entries = {
    Entry{"matte", matte},
    Entry{"plastic", plastic},
    Entry{"translucent", translucent},
    Entry{"glass", glass},
    Entry{"mirror", mirror},
    Entry{"metal", metal},
    Entry{"uber", uber},
    Entry{"substrate", substrate},
    Entry{"disney", disney},
    Entry{"hair", hair},
    Entry{"subsurface", subsurface},
    Entry{"kdsubsurface", kd_subsurface},
    Entry{"fourier", fourier},
    Entry{"mix", mix},
    Entry{"none", no_surface},
};

const Entry& entry_of(const Material& m) {
    return *std::ranges::find(entries, m.plugin.type->name, &Entry::name);
}

/// Returns the number of lobes that a material has at most, with those of its parts.
std::size_t count_lobes(const Kind& kind, const std::vector<PhysicalMaterial>& all, int depth = 0) {
    constexpr int deepest = 8;
    if (const auto* mix = std::get_if<MixedMaterial>(&kind); mix && depth < deepest) {
        return count_lobes(all[mix->first].kind, all, depth + 1) +
               count_lobes(all[mix->second].kind, all, depth + 1);
    }
    return std::visit([]<class K>(const K&) { return most_lobes<K>; }, kind);
}

void warn_of_lost_lobes(SceneBuilder& b, const Material& m, const Kind& built) {
    const std::size_t lobes = count_lobes(built, b.look().materials);
    if (lobes <= LobeList::capacity) return;
    b.warn(m.plugin.where, "lobes",
           "the materials of this mix have up to {} lobes; those after the first {} are left out",
           lobes, LobeList::capacity);
}

}  // namespace

void build_materials(SceneBuilder& b) {
    for (const Material& m : b.frame.materials) {
        PhysicalMaterial built{entry_of(m).build(b, m)};
        warn_of_lost_lobes(b, m, built.kind);
        if (m.plugin.parameters.texture("bumpmap")) {
            built.bump = b.number(m.plugin.parameters, "bumpmap");
        }
        b.look().materials.push_back(built);
    }
}

}  // namespace etalon::pbrt
