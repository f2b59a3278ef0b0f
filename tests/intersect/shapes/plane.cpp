#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

ShapeCase plane(const std::string& name, const Plane& p) {
    ShapeCase c{name, {}, p.point, 1, true, {}, {}};
    c.scene.geometry.add(p, 0);
    c.targets.push_back({"point", [p](Random& random, const Vec3&) {
                             const Vec3 v = random.in_cube();
                             return p.point + 10.0 * v -
                                    10 * v.dot(p.normal) / p.normal.length2() * p.normal;
                         }});
    c.targets.push_back({"grazing", [p](Random& random, const Vec3& from) {
                             const Vec3 v = random.in_cube().cross(p.normal) / p.normal.length();
                             return from + v +
                                    std::pow(10.0, random.uniform(-18, 0)) * random.in_cube();
                         }});
    return c;
}

}  // namespace

std::vector<ShapeCase> plane_cases() {
    return {
        plane("plane", {tilted(0.2, 0.3, 0.4), tilted(0.1, 0.2, 3)}),
        plane("plane across an axis", {{0, 0, 1}, {0, 0, 1}}),
        plane("plane, far from the origin", {far_away, tilted(0.4, 0.1, 1)}),
    };
}

}  // namespace etalon
