#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"
#include "core/test_rays/targets.h"

namespace etalon::hard {
namespace {

/// Returns an S-shaped curve whose coordinates are floats.
Curve bent(CurveType type, const Affine& map) {
    BezierCurve c{{Vec3f(-1, -0.5F, 0), Vec3f(-0.25F, 1, 0.5F), Vec3f(0.25F, -1, -0.25F),
                   Vec3f(1, 0.5F, 0.25F)},
                  {0.125F, 0.0625F}};
    c.normals = {Vec3f(0, 0, 1), Vec3f(0, 1, 0)};
    c.type = type;
    return {c, map};
}

Affine placed_at(const Vec3& origin) {
    Affine map;
    map.origin = origin;
    return map;
}

/// Rays to points all over the curve and to its edges, from up to 10^farthest away.
CaseSetup seen_from(const Curve& curve, double farthest) {
    Scene scene;
    scene.geometry.add(curve, 0);
    const auto targets = targets_of(scene.geometry, 0, to_the_last_bit);
    return only(curve, 2, [=](Random& random) {
        const Vec3 centre = curve.to_world.point(Vec3(0));
        const Vec3 from = centre + random.magnitude(0.5, farthest) * random.direction();
        return towards(from, targets[random.index(targets.size())](from, random));
    });
}

}  // namespace

std::vector<HardCase> curve_cases() {
    Rows rows("curve");
    const Affine sheared{{1, 0, 0.25}, {0.5, 1, 0}, {-2, 3, 1}, usual_place()};
    const std::pair<const char*, CurveType> types[] = {
        {"flat", CurveType::flat}, {"ribbon", CurveType::ribbon}, {"tube", CurveType::cylinder}};
    for (const auto& named : types) {
        const std::string kind(named.first);
        const CurveType type = named.second;  // clang 14 captures no structured binding
        rows.add("CRV-1", kind, [=] { return seen_from(bent(type, placed_at({0, 0, 0})), 2); });
        rows.add("CRV-1", kind + ", at 3e5",
                 [=] { return seen_from(bent(type, placed_at(far_place())), 2); });
        rows.add("CRV-1", kind + ", sheared", [=] { return seen_from(bent(type, sheared), 2); });
        rows.add("CRV-1", kind + ", from 1e5", [=] {
            return seen_from(bent(type, placed_at({0, 0, 0})), 5);
        });
    }
    return rows.take();
}

}  // namespace etalon::hard
