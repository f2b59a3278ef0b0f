// Round shapes of a frame: primitives where there are some for them, else meshes.
#include "core/formats/pbrt/build/shape_builder.h"

namespace etalon::pbrt {
namespace {

bool is_whole_turn(const Parameters& p) {
    return p.number("phimax") >= 360;
}

/// The factor of lengths of a whole turn whose surface coordinates nobody asks for: primitives have
/// their own. Nothing where circles do not stay circles.
std::optional<double> scale_of_circles(const ShapeBuilder& s) {
    if (!is_whole_turn(s.parameters()) || s.has_texture()) return std::nullopt;
    return scale_of(s.to_world);
}

void begin_curved(ShapeBuilder& s) {
    SurfaceBinding binding;
    binding.flipped = s.flips_normals();
    s.begin(binding);
}

void build_side(ShapeBuilder& s, const Circle& from, const Circle& to) {
    if (from.z == to.z || !(std::max(from.radius, to.radius) > 0)) {
        return s.skip("it has no area");
    }
    const std::optional<double> scale = scale_of_circles(s);
    if (!scale) return sweep_side(s, from, to);
    begin_curved(s);
    s.add(Cone{s.to_world.point({0, 0, from.z}), s.to_world.point({0, 0, to.z}),
               *scale * from.radius, *scale * to.radius});
}

}  // namespace

void build_sphere(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double radius = std::abs(p.number("radius"));
    if (!(radius > 0)) return s.skip("its radius is 0");
    const bool whole =
        is_whole_turn(p) && p.number("zmin") <= -radius && p.number("zmax") >= radius;
    if (!whole) return sweep_sphere(s);
    begin_curved(s);
    if (const std::optional<double> scale = scale_of_circles(s)) {
        s.add(Sphere{s.to_world.origin, *scale * radius});
    } else {
        const auto& [x, y, z, origin] = s.to_world;
        s.add(Ellipsoid(Affine{radius * x, radius * y, radius * z, origin}));
    }
}

void build_disk(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double outer = p.number("radius"), inner = p.number("innerradius");
    if (!(outer > inner) || !(inner >= 0)) return s.skip("it has no area");
    const std::optional<double> scale = scale_of_circles(s);
    if (!scale) return sweep_disk(s);
    begin_curved(s);
    s.add(Ring{s.to_world.point({0, 0, p.number("height")}), s.normal({0, 0, 1}).normalized(),
               *scale * inner, *scale * outer});
}

void build_cylinder(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double radius = p.number("radius");
    build_side(s, {p.number("zmin"), radius}, {p.number("zmax"), radius});
}

void build_cone(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    build_side(s, {0, p.number("radius")}, {p.number("height"), 0});
}

}  // namespace etalon::pbrt
