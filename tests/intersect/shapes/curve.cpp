#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

/// A straight, narrow curve: a ray that leaves a bent one may hit it again.
ShapeCase curve(const std::string& name, CurveType type, const Affine& map) {
    BezierCurve c{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto x = static_cast<float>(i) / 3;
        c.points[i] = Vec3f(2 * x - 1, x - 0.5F, 0.25F - x);
    }
    c.widths = {0.03F, 0.02F};
    c.normals = {Vec3f(0, 0, 1), Vec3f(0, 1, 0)};
    c.type = type;
    ShapeCase s{name, {}, map.origin, 1.25 * (map.x.length() + map.y.length() + map.z.length()),
                true, {}, {}};
    s.scene.geometry.add(Curve(c, map), 0);
    // A point at fraction x of the curve's length, displaced by `across` times half its width,
    // perpendicular to the view from `from`.
    const auto at = [map](const Vec3& from, double x, double across) {
        const Vec3 centre = map.point({2 * x - 1, x - 0.5, 0.25 - x});
        const Vec3 side = map.vector({2, 1, -1}).cross(centre - from);
        return centre + across * 0.5 * (0.03 - 0.01 * x) * side.normalized();
    };
    s.targets.push_back({"band", [at](Random& random, const Vec3& from) {
                             return at(from, random.uniform(), random.uniform(-1, 1));
                         }});
    s.targets.push_back({"side", [at](Random& random, const Vec3& from) {
                             const double across = random.sign() * nearly_one(random);
                             return at(from, random.uniform(), across);
                         }});
    s.targets.push_back({"end", [at](Random& random, const Vec3& from) {
                             const double end = random.index(2) == 0 ? 0 : nearly_one(random);
                             return at(from, end, random.uniform(-1, 1));
                         }});
    return s;
}

}  // namespace

std::vector<ShapeCase> curve_cases() {
    Affine near, distant;
    near.origin = base;
    distant.origin = far_away;
    return {
        curve("curve, flat", CurveType::flat, near),
        curve("curve, ribbon", CurveType::ribbon, near),
        curve("curve, cylinder", CurveType::cylinder, near),
        curve("curve, far from the origin", CurveType::cylinder, distant),
    };
}

}  // namespace etalon
