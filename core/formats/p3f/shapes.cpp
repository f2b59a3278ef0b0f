// Spheres, boxes, planes and cones. What cannot be seen is left out with a warning.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/formats/p3f/degenerate.h"
#include "core/formats/p3f/loader.h"
#include "core/numerics/rounding.h"

namespace etalon::p3f {
namespace {

/// A negative radius shows only the inside of a shape.
Sides sides_for(const Loader& loader, double radius) {
    return radius < 0 ? Sides::back : loader.sides();
}

template <class Shape>
void add(Loader& loader, const Shape& shape, Sides sides) {
    loader.scene.add(shape, loader.current_material(), sides);
}

void warn_degenerate(Reader& in, std::string_view why) {
    in.warn("degenerate", "'{}' left out: {}", in.keyword(), why);
}

}  // namespace

void read_sphere(Loader& loader) {
    Reader& in = loader.in;
    const Vec3 centre = in.vector("centre");
    const double radius = in.number("radius");
    if (!in.ok()) return;
    if (radius == 0) return warn_degenerate(in, "its radius is 0");
    add(loader, Sphere{centre, std::abs(radius)}, sides_for(loader, radius));
}

void read_box(Loader& loader) {
    Reader& in = loader.in;
    const Vec3 a = in.vector("lower corner"), b = in.vector("upper corner");
    if (!in.ok()) return;
    Box box{a, b};
    int flat = 0;
    for (int k = 0; k < 3; ++k) {
        if (box.min[k] > box.max[k]) std::swap(box.min[k], box.max[k]);
        if (box.min[k] == box.max[k]) ++flat;
    }
    if (flat > 1) return warn_degenerate(in, "it has no area");
    if (box.min != a) {
        in.warn("degenerate",
                "the corners of 'box' are not the lower and the upper one; exchanged");
    }
    add(loader, box, loader.sides());
}

/// The plane through three points, its front where they run counter-clockwise.
void read_plane(Loader& loader) {
    Reader& in = loader.in;
    const std::array points = {in.vector("first point"), in.vector("second point"),
                               in.vector("third point")};
    if (!in.ok()) return;
    const Vec3 normal = area_normal(points);
    if (!is_finite(normal) || normal == Vec3(0)) {
        return warn_degenerate(in, "its points span no plane");
    }
    add(loader, Plane{points[0], normal}, loader.sides());
}

/// The points with N.p + D = 0.
void read_hessian_plane(Loader& loader) {
    Reader& in = loader.in;
    const Vec3 given = in.vector("normal");
    const double distance = in.number("distance D");
    if (!in.ok()) return;
    const Vec3 normal = to_unit_magnitude(given);
    const double d = distance * power_of_two_reciprocal(max_abs(given));
    const Vec3 point = normal * (-d / normal.dot(normal));
    if (!is_finite(normal) || normal == Vec3(0)) return warn_degenerate(in, "its normal is zero");
    if (!is_finite(point)) return warn_degenerate(in, "it lies beyond all numbers");
    add(loader, Plane{point, normal}, loader.sides());
}

/// The side of a cone or cylinder between two circles about its axis; no caps.
void read_cone(Loader& loader) {
    Reader& in = loader.in;
    const Vec3 base = in.vector("base");
    const double base_radius = in.number("base radius");
    const Vec3 apex = in.vector("apex");
    const double apex_radius = in.number("apex radius");
    if (!in.ok()) return;
    if (base == apex) return warn_degenerate(in, "its base and its apex are one point");
    if (base_radius == 0 && apex_radius == 0) return warn_degenerate(in, "both its radii are 0");
    if ((base_radius < 0) != (apex_radius < 0) && base_radius != 0 && apex_radius != 0) {
        return warn_degenerate(in, "only one of its radii is negative");
    }
    const Sides sides = sides_for(loader, std::min(base_radius, apex_radius));
    add(loader, Cone{base, apex, std::abs(base_radius), std::abs(apex_radius)}, sides);
}

}  // namespace etalon::p3f
