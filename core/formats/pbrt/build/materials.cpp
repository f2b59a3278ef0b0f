// Materials of a frame, each by one line of a table.
#include <array>

#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {
namespace {

using Kind = decltype(PhysicalMaterial::kind);

/// Roughness along u and v by the parameters of these names; where they are not given, by the
/// third.
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

Kind glass(SceneBuilder& b, const Material& m) {
    const Parameters& p = m.plugin.parameters;
    return GlassMaterial{b.color(p, "Kr"), b.color(p, "Kt"), b.number(p, "eta"),
                         roughness(b, p, "uroughness", "vroughness")};
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
    return UberMaterial{b.color(p, "Kd"),
                        b.color(p, "Ks"),
                        b.color(p, "Kr"),
                        b.color(p, "Kt"),
                        b.color(p, "opacity"),
                        b.number(p, "eta"),
                        roughness(b, p, "uroughness", "vroughness", "roughness")};
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
    Entry{"matte", matte},     Entry{"plastic", plastic},     Entry{"translucent", translucent},
    Entry{"glass", glass},     Entry{"mirror", mirror},       Entry{"metal", metal},
    Entry{"uber", uber},       Entry{"substrate", substrate}, Entry{"mix", mix},
    Entry{"none", no_surface},
};

/// What stands in for materials that are not rendered yet.
Kind grey() {
    return MatteMaterial{{Color(0.5F)}, {0.0F}};
}

}  // namespace

void build_materials(SceneBuilder& b) {
    for (const Material& m : b.frame.materials) {
        const auto* const entry = std::ranges::find(entries, m.plugin.type->name, &Entry::name);
        PhysicalMaterial built{entry == entries.end() ? grey() : entry->build(b, m)};
        if (entry == entries.end()) warn_of_stand_in(b, m.plugin);
        if (m.plugin.parameters.texture("bumpmap")) {
            built.bump = b.number(m.plugin.parameters, "bumpmap");
        }
        b.look().materials.push_back(built);
    }
}

}  // namespace etalon::pbrt
