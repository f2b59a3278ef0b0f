#include "core/scene/profiles.h"
#include "tests/intersect/shapes/families.h"

namespace etalon {

std::vector<DegenerateCase> degenerate_cases() {
    std::vector<DegenerateCase> cases;
    const auto add = [&]<class Shape>(const std::string& name, const Shape& shape) {
        cases.push_back({name, {}, true});
        cases.back().scene.geometry.add(shape, 0);
    };
    add("sphere of radius 0", Sphere{{0, 0, 0}, 0});
    add("sphere of negative radius", Sphere{{0, 0, 0}, -1});
    add("cone of no length", Cone{{0, 0, 0}, {0, 0, 0}, 1, 1});
    add("cone of no width", Cone{{0, 0, -1}, {0, 0, 1}, 0, 0});
    add("cone of negative radius", Cone{{0, 0, -1}, {0, 0, 1}, 1, -1});
    add("box inside out", Box{{1, -1, -1}, {-1, 1, 1}});
    add("box inside out in all axes", Box{{1, 1, 1}, {-1, -1, -1}});
    add("plane without a normal", Plane{{0, 0, 0}, {0, 0, 0}});
    const std::pair<const char*, Affine> singular[] = {
        {"of no height", scaling(1, 1, 0)},
        {"of no width", scaling(0, 1, 1)},
        {"sheared flat", {{1, 2, 3}, {3, 1, 7}, {4, 3, 10}}},
    };
    for (const auto& [how, map] : singular) {
        add(std::string("ellipsoid ") + how, Ellipsoid(map));
        add(std::string("closed cylinder ") + how, ClosedCylinder(map));
        add(std::string("revolved ") + how, Revolved(map, profiles::cylinder(), Sector(90)));
        const BezierCurve line{{Vec3f(0), Vec3f(1), Vec3f(2), Vec3f(3)}, {1, 1}};
        add(std::string("curve ") + how, Curve(line, map));
    }
    add("revolved of no height", Revolved({}, profiles::sphere(0.5, 0.5), Sector(360)));
    add("revolved upside down", Revolved({}, profiles::sphere(0.5, -0.5), Sector(360)));
    add("revolved by no angle", Revolved({}, profiles::cylinder(), Sector(0)));
    add("revolved of the axis", Revolved({}, profiles::hyperboloid(0, 0, -1, 1), Sector(360)));
    add("revolved of nothing but holes", Revolved({}, profiles::disk(1), Sector(360)));

    add("ring without a normal", Ring{{0, 0, 0}, {0, 0, 0}, 0, 1});
    add("ring of no width", Ring{{0, 0, 0}, {0, 0, 1}, 0, 0});
    add("ring inside out", Ring{{0, 0, 0}, {0, 0, 1}, 1, 0.5});
    add("ring of negative radius", Ring{{0, 0, 0}, {0, 0, 1}, -0.5, 1});
    add("curve of no width", Curve({{Vec3f(0), Vec3f(1), Vec3f(2), Vec3f(3)}, {0, 0}}, Affine{}));
    add("quadric of nothing", Quadric{{0, 0, 0}, {}, around(Vec3(0), 1)});
    add("quadric of a constant",
        Quadric{{0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, around(Vec3(0), 1)});
    add("quadric clipped away",
        Quadric{{0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}, {Vec3(1), Vec3(-1)}});

    const auto add_flat = [&](const std::string& name, const std::vector<Vec3>& p, bool empty) {
        cases.push_back({name, flat_case(name, p).scene, empty});
    };
    const Vec3 a(-1, 0, 0), b(1, 0, 0), c(3, 0, 0);
    add_flat("triangle of one point", {a, a, a}, false);
    add_flat("triangle on a line", {a, b, c}, false);
    add_flat("triangle with two equal corners", {a, b, b}, false);
    add_flat("polygon of one point", {a, a, a, a}, true);
    add_flat("polygon on a line", {a, b, c, b}, true);
    add_flat("polygon that cancels itself", {{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}, true);
    return cases;
}

}  // namespace etalon
