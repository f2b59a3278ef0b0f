// Boxes and planes. Those that cannot be seen are left out with a warning.
#include <algorithm>
#include <array>

#include "core/formats/p3f/p3f_loader.h"
#include "core/formats/polygon_normal.h"
#include "core/numerics/rounding.h"

namespace etalon::p3f {

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
    if (flat > 1) return loader.skip_degenerate("it has no area");
    if (box.min != a) {
        in.warn("degenerate",
                "the corners of 'box' are not the lower and the upper one; exchanged");
    }
    loader.add(box, loader.sides());
}

/// Reads the plane through three points; its front is where they run counter-clockwise.
void read_plane(Loader& loader) {
    Reader& in = loader.in;
    const std::array points = {in.vector("first point"), in.vector("second point"),
                               in.vector("third point")};
    if (!in.ok()) return;
    const Vec3 normal = area_normal(points);
    if (!is_finite(normal) || normal == Vec3(0)) {
        return loader.skip_degenerate("its points span no plane");
    }
    loader.add(Plane{points[0], to_unit_magnitude(normal)}, loader.sides());
}

/// Reads the plane of the points with N.p + D = 0.
void read_hessian_plane(Loader& loader) {
    Reader& in = loader.in;
    const Vec3 given = in.vector("normal");
    const double distance = in.number("distance D");
    if (!in.ok()) return;
    const Vec3 normal = to_unit_magnitude(given);
    const double d = distance * power_of_two_reciprocal(max_abs(given));
    const Vec3 point = normal * (-d / normal.dot(normal));
    if (!is_finite(normal) || normal == Vec3(0))
        return loader.skip_degenerate("its normal is zero");
    if (!is_finite(point)) return loader.skip_degenerate("its position is not finite");
    loader.add(Plane{point, normal}, loader.sides());
}

}  // namespace etalon::p3f
