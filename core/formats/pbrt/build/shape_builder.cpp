#include "core/formats/pbrt/build/shape_builder.h"

namespace etalon::pbrt {
namespace {

bool same(const NumberSlot& a, const NumberSlot& b) {
    return a.value == b.value && a.texture == b.texture;
}

bool same(const SurfaceBinding& a, const SurfaceBinding& b) {
    return a.material == b.material && a.flipped == b.flipped &&
           a.corner_normals == b.corner_normals && a.light == b.light &&
           a.uv_offset == b.uv_offset && same(a.alpha, b.alpha) &&
           same(a.shadow_alpha, b.shadow_alpha);
}

}  // namespace

Vec3 ShapeBuilder::normal(const Vec3& n) const {
    const auto& [x, y, z, origin] = to_world;
    const Vec3 across = n.x * y.cross(z) + n.y * z.cross(x) + n.z * x.cross(y);
    return std::copysign(1.0, to_world.determinant()) * across;
}

std::optional<double> ShapeBuilder::scale() const {
    const auto& [x, y, z, origin] = to_world;
    const double xx = x.dot(x), tolerance = 1e-5 * xx;  // what floats of a file leave of it
    const bool alike = std::abs(y.dot(y) - xx) <= tolerance && std::abs(z.dot(z) - xx) <= tolerance;
    const bool square = std::abs(x.dot(y)) <= tolerance && std::abs(y.dot(z)) <= tolerance &&
                        std::abs(z.dot(x)) <= tolerance;
    if (!alike || !square) return std::nullopt;
    return std::cbrt(std::abs(to_world.determinant()));
}

void ShapeBuilder::begin(SurfaceBinding binding) {
    PhysicalLook& look = b.look();
    binding.material = shape.material;
    if (shape.plugin.type->find("alpha") != nullptr) {
        binding.alpha = b.number(parameters(), "alpha");
        binding.shadow_alpha = b.number(parameters(), "shadowalpha");
    }
    if (shape.area_light != none) {
        binding.light = static_cast<std::uint32_t>(look.lights.size());
        binding.first = static_cast<std::uint32_t>(geometry().primitives.size());
    }
    if (look.bindings.empty() || !same(look.bindings.back(), binding)) {
        look.bindings.push_back(binding);
    }
    binding_ = static_cast<std::uint32_t>(look.bindings.size() - 1);
}

void ShapeBuilder::add_light() {
    if (shape.area_light == none) return;
    const Parameters& p = b.frame.area_lights[shape.area_light].parameters;
    b.look().lights.emplace_back(
        AreaSource{static_cast<std::uint32_t>(geometry().primitives.size()),
                   p.color("L") * p.color("scale"), p.flag("twosided")});
}

void ShapeBuilder::leave_out(std::string_view why) const {
    b.warn(shape.plugin.where, "shape", "\"{}\" left out: {}", shape.plugin.type->name, why);
}

}  // namespace etalon::pbrt
