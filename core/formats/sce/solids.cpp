// ball and cylinder. Under a matrix they are ellipsoids and slanted cylinders.
#include <cmath>

#include "core/formats/sce/sce_loader.h"
#include "core/numerics/transforms.h"

namespace etalon::sce {
namespace {

/// Returns the scale of a map that certainly takes spheres to spheres: its columns lie along axes
/// and have one length. 0 for any other.
double uniform_scale(const Affine& m) {
    for (const Vec3& column : {m.x, m.y, m.z}) {
        const bool along_axis =
            std::abs(column.x) + std::abs(column.y) + std::abs(column.z) == max_abs(column);
        if (!along_axis || max_abs(column) != max_abs(m.x)) return 0;
    }
    return max_abs(m.x);
}

/// A shape whose numbers have overflowed or underflowed cannot be hit by any ray.
template <class Shape>
void add_image(Loader& loader, Reader& in, const Affine& map) {
    const Shape shape(map);
    if (shape.frame.exists()) return loader.add(shape);
    in.warn("matrix", "'{}' left out: its size is not finite", in.keyword());
}

}  // namespace

void read_ball(Loader& loader, Reader& in) {
    const double radius = std::abs(in.number("radius"));
    const Vec3 centre = in.vector("centre");
    if (!in.ok() || !loader.has_usable_matrix(in)) return;
    if (radius == 0) return in.warn("degenerate", "'ball' left out: its radius is 0");
    const Affine map = loader.state.matrix * translation(centre) * scaling(Vec3(radius));
    const double scale = uniform_scale(map);
    if (scale > 0 && is_finite(map)) return loader.add(Sphere{map.origin, scale});
    add_image<Ellipsoid>(loader, in, map);
}

void read_cylinder(Loader& loader, Reader& in) {
    if (loader.has_usable_matrix(in)) add_image<ClosedCylinder>(loader, in, loader.state.matrix);
}

}  // namespace etalon::sce
