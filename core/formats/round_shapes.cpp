// Spheres and cones. Those that cannot be seen are left out with a warning.
#include <algorithm>
#include <cmath>

#include "core/formats/scene_loader.h"

namespace etalon {

void read_sphere(SceneLoader& loader) {
    Reader& in = loader.in;
    const Vec3 centre = in.vector("centre");
    const double radius = in.number("radius");
    if (!in.ok()) return;
    if (radius == 0) return loader.skip_degenerate("its radius is 0");
    loader.add(Sphere{centre, std::abs(radius)}, loader.sides_for(radius));
}

/// Reads the side of a cone or cylinder between two circles about its axis, without caps.
void read_cone(SceneLoader& loader) {
    Reader& in = loader.in;
    const Vec3 base = in.vector("base");
    const double base_radius = in.number("base radius");
    const Vec3 apex = in.vector("apex");
    const double apex_radius = in.number("apex radius");
    if (!in.ok()) return;
    if (base == apex) return loader.skip_degenerate("its base and its apex are one point");
    if (base_radius == 0 && apex_radius == 0) return loader.skip_degenerate("both its radii are 0");
    if ((base_radius < 0) != (apex_radius < 0) && base_radius != 0 && apex_radius != 0) {
        return loader.skip_degenerate("only one of its radii is negative");
    }
    loader.add(Cone{base, apex, std::abs(base_radius), std::abs(apex_radius)},
               loader.sides_for(std::min(base_radius, apex_radius)));
}

}  // namespace etalon
