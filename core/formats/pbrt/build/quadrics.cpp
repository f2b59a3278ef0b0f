// Round shapes of a frame.
#include "core/formats/pbrt/build/shape_builder.h"
#include "core/scene/profiles.h"

namespace etalon::pbrt {
namespace {

bool is_whole_turn(const Parameters& p) {
    return p.number("phimax") >= 360;
}

/// Returns the magnitude of a radius: pbrt-v3 squares it, so that its sign has no effect on hits.
double radius_of(const Parameters& p, std::string_view name = "radius") {
    return std::abs(p.number(name));
}

/// Returns the scale of the map if the shape can be a sphere or a ring: a whole turn whose surface
/// coordinates are not needed, since those of spheres and rings differ. Nothing if it cannot, or if
/// the map does not preserve circles.
std::optional<double> scale_of_circles(const ShapeBuilder& s) {
    if (!is_whole_turn(s.parameters()) || s.needs_coordinates()) return std::nullopt;
    return scale_of(s.to_world);
}

void begin_curved(ShapeBuilder& s, bool turned_inside_out = false) {
    SurfaceBinding binding;
    binding.flipped = s.flips_normals() != turned_inside_out;
    s.begin(binding);
}

/// Returns the map that gives a unit shape its width and height, with its origin at a height.
Affine unit_to_shape(double radius, double height, double origin) {
    return {{radius, 0, 0}, {0, radius, 0}, {0, 0, height}, {0, 0, origin}};
}

/// Adds a part of a unit shape, up to phimax. pbrt-v3's normal points inward where v decreases with
/// the height.
void add_revolved(ShapeBuilder& s, const Affine& to_shape, const Profile& profile,
                  const TurningDirection& start = {}) {
    const double degrees = std::clamp<double>(s.parameters().number("phimax"), 0, 360);
    const Revolved surface(s.to_world * to_shape, profile, Sector(degrees, start));
    if (!surface.exists()) return s.skip("it has no area");
    begin_curved(s, profile.falls && !profile.is_flat());
    s.add(surface);
}

/// x^2 + y^2 = radius2 + widening z^2.
struct Waist {
    double radius2, widening;
};

/// Returns the hyperboloid about z = 0 that pbrt-v3 draws for a line. It meets the line in p2 and
/// in p1 moved by twice the vector to p2. It is the surface that the line sweeps only if that is
/// narrowest at z = 0.
std::optional<Waist> waist_through(const Vec3& p1, const Vec3& p2) {
    Vec3 p = p1;
    for (int i = 0; i < 8; ++i) {
        p += 2.0 * (p2 - p1);
        const double squares = p.z * p.z - p2.z * p2.z, near2 = p2.x * p2.x + p2.y * p2.y;
        const double widening = (p.x * p.x + p.y * p.y - near2) / squares;
        if (std::isfinite(widening)) return Waist{near2 - widening * p2.z * p2.z, widening};
    }
    return std::nullopt;
}

/// Returns the direction of the line's point at a height, in a shape scaled by a factor.
TurningDirection direction_along(const Vec3& p1, const Vec3& p2, double radius, double height) {
    const Vec2 from(p1.x, p1.y), step(p2.x - p1.x, p2.y - p1.y);
    const Vec2 per_height = step / (p2.z - p1.z);
    return {(from - p1.z * per_height) / radius, per_height * (height / radius)};
}

}  // namespace

void build_sphere(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double radius = radius_of(p);
    if (!(radius > 0)) return s.skip("its radius is 0");
    const auto height = [&](std::string_view name) {
        return std::clamp(p.number(name) / radius, -1.0, 1.0);
    };
    const double low = std::min(height("zmin"), height("zmax")),
                 high = std::max(height("zmin"), height("zmax"));
    if (!is_whole_turn(p) || low > -1 || high < 1) {
        return add_revolved(s, unit_to_shape(radius, radius, 0), profiles::sphere(low, high));
    }
    begin_curved(s);
    if (const std::optional<double> scale = scale_of_circles(s)) {
        s.add(Sphere{s.to_world.origin, *scale * radius});
    } else {
        s.add(Ellipsoid(s.to_world * unit_to_shape(radius, radius, 0)));
    }
}

void build_disk(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double outer = radius_of(p), inner = radius_of(p, "innerradius");
    if (!(outer > inner)) return s.skip("it has no area");
    const double height = p.number("height");
    const std::optional<double> scale = scale_of_circles(s);
    if (!scale) {
        return add_revolved(s, unit_to_shape(outer, outer, height), profiles::disk(inner / outer));
    }
    begin_curved(s);
    s.add(Ring{s.to_world.point({0, 0, height}), s.normal({0, 0, 1}).normalized(), *scale * inner,
               *scale * outer});
}

void build_cylinder(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double low = std::min(p.number("zmin"), p.number("zmax")),
                 high = std::max(p.number("zmin"), p.number("zmax"));
    add_revolved(s, unit_to_shape(radius_of(p), high - low, low), profiles::cylinder());
}

void build_cone(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double height = p.number("height");
    if (!(height > 0)) return s.skip("it has no area");
    add_revolved(s, unit_to_shape(radius_of(p), height, height), profiles::cone());
}

void build_paraboloid(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const double low = std::min(p.number("zmin"), p.number("zmax")),
                 high = std::max(p.number("zmin"), p.number("zmax"));
    if (!(high > 0)) return s.skip("it has no area");
    add_revolved(s, unit_to_shape(radius_of(p), high, 0), profiles::paraboloid(low / high));
}

void build_hyperboloid(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    Vec3 p1(p.vector("p1")), p2(p.vector("p2"));
    if (p2.z == 0) std::swap(p1, p2);
    const std::optional<Waist> waist = waist_through(p1, p2);
    const double radius = std::max(std::hypot(p1.x, p1.y), std::hypot(p2.x, p2.y)),
                 height = std::max(std::abs(p1.z), std::abs(p2.z));
    if (p1.z == p2.z || !waist || !(radius > 0)) return s.skip("it has no area");
    Profile profile = profiles::hyperboloid(
        waist->radius2 / (radius * radius), waist->widening * (height / radius) * (height / radius),
        std::min(p1.z, p2.z) / height, std::max(p1.z, p2.z) / height);
    profile.along = Profile::Along::line;
    profile.falls = p2.z < p1.z;
    add_revolved(s, unit_to_shape(radius, height, 0), profile,
                 direction_along(p1, p2, radius, height));
}

}  // namespace etalon::pbrt
