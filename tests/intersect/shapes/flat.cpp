#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

void add_outline_targets(ShapeCase& c, const std::vector<Vec3>& p) {
    c.targets.push_back({"vertex", [p](Random& random, const Vec3&) {
                             return p[static_cast<std::size_t>(random.index(p.size()))];
                         }});
    c.targets.push_back({"edge", [p](Random& random, const Vec3&) {
                             const auto i = static_cast<std::size_t>(random.index(p.size()));
                             const Vec3 &a = p[i], &b = p[(i + 1) % p.size()];
                             return a + random.uniform() * (b - a);
                         }});
    c.targets.push_back({"middle", [p](Random& random, const Vec3&) {
                             const auto i = static_cast<std::size_t>(random.index(p.size()));
                             return 0.5 * (p[i] + p[(i + 1) % p.size()]);
                         }});
    c.targets.push_back({"face", [p](Random& random, const Vec3&) {
                             Vec3 sum(0);
                             double weight = 0;
                             for (const Vec3& corner : p) {
                                 const double w = -std::log(1 - random.uniform());
                                 sum += w * corner;
                                 weight += w;
                             }
                             return sum / weight;
                         }});
}

std::vector<Vec3> star(int points, double inner) {
    std::vector<Vec3> p;
    for (int i = 0; i < 2 * points; ++i) {
        const double r = i % 2 == 0 ? 1 : inner, angle = pi * i / points;
        p.push_back(tilted(r * std::cos(angle), r * std::sin(angle), 0.25));
    }
    return p;
}

std::vector<Vec3> moved(std::vector<Vec3> p, const Vec3& by) {
    for (Vec3& corner : p) corner += by;
    return p;
}

}  // namespace

ShapeCase flat_case(const std::string& name, const std::vector<Vec3>& p) {
    Box3 box;
    for (const Vec3& corner : p) box.extendBy(corner);
    ShapeCase c{name, {}, box.center(), box.size().length() / 2, true, {}, {}};
    c.scene.geometry.vertices.assign(p.begin(), p.end());
    if (p.size() == 3) {
        c.scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    } else {
        c.scene.geometry.add(Polygon{p}, 0);
    }
    add_outline_targets(c, p);
    return c;
}

std::vector<ShapeCase> flat_cases() {
    const std::vector<Vec3> bent = {
        {0, 0, 1e-6}, {2, 0, -1e-6}, {2, 1, 1e-6}, {0.5, 1.5, 0}, {0, 1, -1e-6}};
    const std::vector<Vec3> notched = {{0, 0, 3}, {4, 0, 3}, {4, 4, 3}, {2, 2, 3}, {0, 4, 3}};
    return {
        flat_case("triangle", {tilted(0, 0, 1), tilted(2, 0.25, 1), tilted(0.5, 1.5, 1)}),
        flat_case("triangle across an axis", {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}),
        flat_case("triangle, sliver", {tilted(0, 0, 0), tilted(1, 0, 0), tilted(0.5, 1e-9, 0)}),
        flat_case("triangle, far from the origin",
                  moved({{0, 0, 0}, {2, 0.25, 0.5}, {0.5, 1.5, 0}}, far_away)),
        flat_case("polygon, quad",
                  {tilted(0, 0, 1), tilted(2, 0, 1), tilted(2, 1, 1), tilted(0, 1, 1)}),
        flat_case("polygon, notched, across an axis", notched),
        flat_case("polygon, star", star(7, 0.4)),
        flat_case("polygon, circle", star(40, std::cos(pi / 40))),
        flat_case("polygon, corners off the plane", bent),
        flat_case("polygon, far from the origin", moved(star(5, 0.3), far_away)),
    };
}

}  // namespace etalon
