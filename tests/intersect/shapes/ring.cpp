#include "core/test_rays/directions.h"
#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

ShapeCase ring(const std::string& name, const Ring& r) {
    ShapeCase c{name, {}, r.centre, r.outer, true, {}, {}};
    c.scene.geometry.add(r, 0);
    const auto at = [r](double radius, Random& random) {
        return r.centre + radius * across(r.normal.normalized(), random.uniform(0, 2 * pi));
    };
    c.targets.push_back({"surface", [=](Random& random, const Vec3&) {
                             return at(random.uniform(r.inner, r.outer), random);
                         }});
    c.targets.push_back({"hole", [=](Random& random, const Vec3&) {
                             return at(r.inner * random.uniform(), random);
                         }});
    c.targets.push_back({"rim", [=](Random& random, const Vec3&) {
                             return at(random.index(2) == 0 ? r.inner : r.outer, random);
                         }});
    c.targets.push_back({"next to a rim", [=](Random& random, const Vec3&) {
                             const double rim = random.index(2) == 0 ? r.inner : r.outer;
                             return at(rim * nearly_one(random), random);
                         }});
    return c;
}

}  // namespace

std::vector<ShapeCase> ring_cases() {
    return {
        ring("ring", {base, tilted(0, 0, 3), 0.5, 1}),
        ring("ring, far from the origin", {far_away, tilted(0, 0.3, 3), 0.5, 2}),
        ring("ring, full disc across an axis", {{0, 0, 1}, {0, 0, -1}, 0, 2}),
        ring("ring, narrow", {base, tilted(0.1, 0.2, 3), 1 - 0x1p-10, 1}),
    };
}

}  // namespace etalon
