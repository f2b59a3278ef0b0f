#include "bench/hard_cases/random_shapes.h"

#include "core/scene/profiles.h"

namespace etalon::hard {

Revolved random_revolved(const Affine& map, Random& random) {
    const std::array profiles = {profiles::sphere(random.uniform(-1, 0), random.uniform(0.25, 1)),
                                 profiles::cylinder(),
                                 profiles::cone(),
                                 profiles::paraboloid(random.uniform(0, 0.5)),
                                 profiles::hyperboloid(random.uniform(0, 0.5), 0.5, -1, 1),
                                 profiles::disk(random.uniform(0, 0.5))};
    const double degrees = random.index(2) == 0 ? 360 : random.uniform(30, 360);
    return {map, profiles[random.index(profiles.size())], Sector(degrees)};
}

Curve random_curve(const Affine& map, Random& random) {
    BezierCurve c{};
    for (Vec3f& p : c.points) p = Vec3f(random.in_cube());
    for (float& width : c.widths) width = static_cast<float>(random.uniform(0.02, 0.3));
    for (Vec3f& n : c.normals) n = Vec3f(random.direction());
    c.type = static_cast<CurveType>(random.index(3));
    const auto number = static_cast<std::uint32_t>(random.index(4));
    return Curve(c, map, {number, 4});
}

}  // namespace etalon::hard
