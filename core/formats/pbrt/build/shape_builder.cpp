#include "core/formats/pbrt/build/shape_builder.h"

#include <algorithm>

namespace etalon::pbrt {
namespace {

bool same(const NumberSlot& a, const NumberSlot& b) {
    return a.value == b.value && a.texture == b.texture;
}

bool same(const SurfaceBinding& a, const SurfaceBinding& b) {
    return a.material == b.material && a.flipped == b.flipped &&
           a.corner_normals == b.corner_normals && a.light == b.light &&
           a.uv_offset == b.uv_offset && same(a.alpha, b.alpha) &&
           same(a.shadow_alpha, b.shadow_alpha) && a.media == b.media;
}

bool shows_texture(const Plugin& material) {
    return std::ranges::any_of(material.parameters.arguments(), [](const Argument& a) {
        return std::holds_alternative<TextureNumber>(a.values);
    });
}

/// Returns whether a material without textures may be anisotropic.
bool may_have_grain(const Plugin& material) {
    const Parameters& p = material.parameters;
    if (material.type->name == "hair") return true;
    if (p.is_given("anisotropic")) return p.number("anisotropic") != 0;
    const bool u = p.is_given("uroughness"), v = p.is_given("vroughness");
    return u != v || (u && p.number("uroughness") != p.number("vroughness"));
}

/// Returns whether a material, or a part of a mix, needs surface coordinates. Deeply nested mixes
/// are assumed to.
bool asks_for_coordinates(const Frame& frame, const Material& m, int depth) {
    constexpr int deepest = 8;
    if (depth > deepest || shows_texture(m.plugin) || may_have_grain(m.plugin)) return true;
    return std::ranges::any_of(m.mixed, [&](std::uint32_t part) {
        return part != none && asks_for_coordinates(frame, frame.materials[part], depth + 1);
    });
}

}  // namespace

Vec3 ShapeBuilder::normal(const Vec3& n) const {
    const auto& [x, y, z, origin] = to_world;
    const Vec3 across = n.x * y.cross(z) + n.y * z.cross(x) + n.z * x.cross(y);
    return std::copysign(1.0, to_world.determinant()) * across;
}

bool ShapeBuilder::needs_coordinates() const {
    return asks_for_coordinates(b.frame, b.frame.materials[shape.material], 0);
}

void ShapeBuilder::begin(SurfaceBinding binding) {
    PhysicalLook& look = b.look();
    binding.material = shape.material;
    binding.media = {shape.media.inside, shape.media.outside};
    if (shape.plugin.type->find("alpha") != nullptr) {
        binding.alpha = b.number(parameters(), "alpha");
        binding.shadow_alpha = b.number(parameters(), "shadowalpha");
    }
    sides_ = binding.is_cut_out() ? Sides::cut_out : Sides::both;
    if (shape.area_light != none) binding.light = static_cast<std::uint32_t>(look.lights.size());
    if (look.bindings.empty() || !same(look.bindings.back(), binding)) {
        look.bindings.push_back(binding);
    }
    binding_ = static_cast<std::uint32_t>(look.bindings.size() - 1);
}

void ShapeBuilder::add_to_light() {
    if (shape.area_light == none) return;
    std::vector<PhysicalLight>& lights = b.look().lights;
    const std::uint32_t light = b.look().bindings[binding_].light;
    if (light < lights.size()) {
        ++std::get<AreaSource>(lights[light]).count;
        return;
    }
    const Parameters& p = b.frame.area_lights[shape.area_light].parameters;
    const auto first = static_cast<std::uint32_t>(geometry().primitives.size());
    lights.emplace_back(AreaSource{first, 1, p.color("L") * p.color("scale"), p.flag("twosided"),
                                   light_samples(b, p)});
}

void ShapeBuilder::skip(std::string_view why) const {
    b.warn(shape.plugin.where, "shape", "\"{}\" left out: {}", shape.plugin.type->name, why);
}

}  // namespace etalon::pbrt
