// Round shapes of a frame, as far as there are primitives for them: whole ones.
#include "core/formats/pbrt/build/shape_builder.h"

namespace etalon::pbrt {
namespace {

bool is_whole_turn(const Parameters& p) {
    return p.number("phimax") >= 360;
}

/// A map of the unit sphere or cylinder to one of this radius.
Affine stretched(const Affine& map, double radius, double height, double z) {
    return {radius * map.x, radius * map.y, height * map.z, map.point({0, 0, z})};
}

void begin_curved(ShapeBuilder& s) {
    SurfaceBinding binding;
    binding.flipped = s.flips_outward();
    s.begin(binding);
}

/// The side of a cone between two heights, where the map leaves circles circles.
void build_side(ShapeBuilder& s, double z0, double z1, double radius0, double radius1) {
    const std::optional<double> scale = s.scale();
    if (!is_whole_turn(s.parameters())) return s.leave_out("parts of a turn are not rendered yet");
    if (!scale) return s.leave_out("its transform does not keep circles");
    if (!(z0 != z1) || !(std::max(radius0, radius1) > 0)) return s.leave_out("it has no area");
    begin_curved(s);
    s.add(Cone{s.to_world.point({0, 0, z0}), s.to_world.point({0, 0, z1}), *scale * radius0,
               *scale * radius1});
}

}  // namespace

void build_sphere(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double radius = std::abs(p.number("radius"));
    if (!(radius > 0)) return s.leave_out("its radius is 0");
    const bool whole =
        is_whole_turn(p) && p.number("zmin") <= -radius && p.number("zmax") >= radius;
    if (!whole) return s.leave_out("parts of a sphere are not rendered yet");
    begin_curved(s);
    const std::optional<double> scale = s.scale();
    // Only an ellipsoid knows where its texture begins.
    if (scale && s.b.frame.textures.empty()) {
        s.add(Sphere{s.to_world.origin, *scale * radius});
    } else {
        s.add(Ellipsoid(stretched(s.to_world, radius, radius, 0)));
    }
}

void build_disk(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double outer = p.number("radius"), inner = p.number("innerradius");
    const std::optional<double> scale = s.scale();
    if (!is_whole_turn(p)) return s.leave_out("parts of a turn are not rendered yet");
    if (!scale) return s.leave_out("its transform does not keep circles");
    if (!(outer > inner) || !(inner >= 0)) return s.leave_out("it has no area");
    begin_curved(s);
    s.add(Ring{s.to_world.point({0, 0, p.number("height")}), s.normal({0, 0, 1}).normalized(),
               *scale * inner, *scale * outer});
}

void build_cylinder(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    build_side(s, p.number("zmin"), p.number("zmax"), p.number("radius"), p.number("radius"));
}

void build_cone(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    build_side(s, 0, p.number("height"), p.number("radius"), 0);
}

}  // namespace etalon::pbrt
