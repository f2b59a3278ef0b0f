#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

/// The targets of the unit shape, transformed to its image.
template <class Shape>
ShapeCase affine(const std::string& name, const Affine& map, const ShapeCase& unit) {
    const Shape shape(map);
    const double size = map.x.length() + map.y.length() + map.z.length();
    ShapeCase c{name, {}, map.point(unit.centre), size, true, {}, {}};
    c.scene.geometry.add(shape, 0);
    for (const Target& target : unit.targets) {
        c.targets.push_back({target.name, [=](Random& random, const Vec3& from) {
                                 const Vec3 seen = shape.frame.vector(from - map.origin);
                                 return shape.frame.point(target.point(random, seen));
                             }});
    }
    return c;
}

ShapeCase ellipsoid(const std::string& name, const Affine& map) {
    return affine<Ellipsoid>("ellipsoid, " + name, map, sphere_case(name, {{0, 0, 0}, 1}));
}

ShapeCase closed_cylinder(const std::string& name, const Affine& map) {
    ShapeCase unit = cone_case(name, {{0, 0, 0}, {0, 0, 1}, 1, 1});
    unit.targets.push_back({"cap", [](Random& random, const Vec3&) {
                                const double angle = random.uniform(0, 2 * pi);
                                const double r = std::sqrt(random.uniform());
                                const auto z = static_cast<double>(random.index(2));
                                return Vec3(r * std::cos(angle), r * std::sin(angle), z);
                            }});
    return affine<ClosedCylinder>("closed cylinder, " + name, map, unit);
}

/// Affine maps of every kind: stretching, shearing, mirroring, ill-conditioned, far away.
struct NamedMap {
    std::string name;
    Affine map;
};
std::vector<NamedMap> affine_maps() {
    const Affine askew = rotation(), shear{{1, 0, 0}, {0.5, 1, 0}, {-2, 3, 1}};
    const Affine turned{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}};
    Affine distant = askew * scaling(1, 2, 0.5);
    distant.origin = far_away;
    return {
        {"unit", {}},
        {"odd", askew * scaling(1, 0.5, 2)},
        {"sheared", shear},
        {"mirrored", askew * scaling(-1, 1, 2)},
        {"mirrored and sheared", shear * scaling(1, 1, -0.5)},
        {"needle", askew * scaling(1, 1, 1e4)},
        {"disk", askew * scaling(1, 1, 1e-4)},
        {"condition 1e6", askew * scaling(1, 1e-3, 1e-6) * turned * shear},
        {"condition 1e8", askew * scaling(1e-4, 1e4, 1) * turned * askew},
        {"far from the origin", distant},
    };
}

}  // namespace

std::vector<ShapeCase> affine_cases() {
    std::vector<ShapeCase> cases;
    for (const auto& [map_name, map] : affine_maps()) {
        cases.push_back(ellipsoid(map_name, map));
        cases.push_back(closed_cylinder(map_name, map));
    }
    return cases;
}

}  // namespace etalon
