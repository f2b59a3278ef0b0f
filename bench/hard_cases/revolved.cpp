// Partial surfaces of revolution: edges, silhouettes and apexes, from close by and from far away.
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_generators.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"
#include "core/scene/profiles.h"
#include "core/test_rays/revolved_points.h"

namespace etalon::hard {
namespace {

/// Returns a map with every number rounded to float.
Affine of_floats(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin) {
    return {rounded(x), rounded(y), rounded(z), rounded(origin)};
}

Affine askew(const Vec3& place) {
    return of_floats(tilted(1, 0, 0), tilted(0, 1, 0), tilted(0, 0, 1), place);
}

Affine sheared() {
    return of_floats({1, 0, 0.25}, {0.5, 1, 0}, {-2, 3, 1}, usual_place());
}

Affine of_condition(double condition) {
    const double root = std::sqrt(condition);
    const Vec3 x = tilted(0.6, 0.8, 0), y = tilted(-0.8, 0.6, 0) / root,
               z = tilted(0, 0, 1) / condition;
    return of_floats(0.6 * x + 0.8 * y, 0.6 * y - 0.8 * x + z, z - 0.5 * x, usual_place());
}

struct NamedProfile {
    std::string name;
    Profile profile;
    bool is_concave = false;  ///< a ray that leaves it to the outside may hit it again
};

std::vector<NamedProfile> curves() {
    return {
        {"sphere", profiles::sphere(-0.5, 0.75)},
        {"cylinder", profiles::cylinder()},
        {"cone", profiles::cone()},
        {"paraboloid", profiles::paraboloid(0.25)},
        {"paraboloid with its tip", profiles::paraboloid(0)},
        {"hyperboloid", profiles::hyperboloid(0.25, 0.75, -1, 1), true},
        {"disk", profiles::disk(0)},
        {"ring", profiles::disk(0.5)},
    };
}

/// A hyperboloid swept by a line segment.
Revolved twisted(const Affine& map) {
    Profile line = profiles::hyperboloid(1, 0.25, -1, 1);
    line.along = Profile::Along::line;
    return {map, line, Sector(210, {{1, 0}, {0, 0.5}})};
}

double size_of(const Revolved& s) {
    return s.to_world.x.length() + s.to_world.y.length() + s.to_world.z.length();
}

CaseSetup aimed(const Revolved& s) {
    CaseSetup setup = only(s, size_of(s), nullptr);
    const std::vector<Target> targets = targets_of(setup.scene.geometry, 0, to_the_last_bit);
    const Extent extent{s.to_world.origin, setup.size};
    setup.ray = [=](Random& random) {
        return ray_generator(extent, targets[random.index(targets.size())], random);
    };
    return setup;
}

/// Rays from a distance of so many sizes.
CaseSetup from_afar(const Revolved& s, double distance) {
    CaseSetup setup = only(s, size_of(s), nullptr);
    const std::vector<Target> targets = targets_of(setup.scene.geometry, 0, to_the_last_bit);
    setup.ray = [=, size = setup.size](Random& random) {
        const Vec3 from = s.to_world.origin + distance * size * random.direction();
        return towards(from, targets[random.index(targets.size())](from, random));
    };
    return setup;
}

/// Rays at points exactly on an edge, up to rounding, in directions that cross the edge.
CaseSetup at_edges(const Revolved& s) {
    CaseSetup setup = only(s, size_of(s), nullptr);
    const RevolvedPoints points(s);
    setup.ray = [=, size = setup.size](Random& random) {
        const bool at_rim = s.sector.is_whole || random.index(2) == 0;
        const Vec3 edge = at_rim ? points.on_rim(1, random) : points.on_side(1, random);
        const Vec3 from = s.to_world.origin + 2 * size * random.direction();
        return towards(from, s.to_world.point(edge));
    };
    return setup;
}

void add_curve(Rows& rows, const NamedProfile& curve) {
    const Vec3 here = usual_place();
    const Profile p = curve.profile;
    for (const double degrees : {360.0, 180.0, 290.0}) {
        const Sector sector(degrees);
        const std::string name = curve.name + (sector.is_whole  ? ""
                                               : degrees == 180 ? ", half"
                                                                : ", most of a turn");
        rows.add_both("REV-1", name, [=] { return aimed({askew(here), p, sector}); });
        rows.add("REV-2", name + ", sheared", [=] { return aimed({sheared(), p, sector}); });
        rows.add("REV-3", name + ", edges", [=] { return at_edges({askew(here), p, sector}); });
        rows.add("REV-3", name + ", edges along the axes", [=] {
            return at_edges({{}, p, sector});
        });
    }
    if (curve.is_concave || curve.name == "cone") return;
    rows.add(
        "REV-5", curve.name + ", leaving",
        [=] {
            return aimed({askew(here), p, Sector(290)});
        },
        Criterion::spawned);
    rows.add(
        "REV-5", curve.name + ", leaving, sheared",
        [=] {
            return aimed({sheared(), p, Sector(290)});
        },
        Criterion::spawned);
}

}  // namespace

std::vector<HardCase> revolved_cases() {
    Rows rows("revolved");
    for (const NamedProfile& curve : curves()) add_curve(rows, curve);
    rows.add_both("REV-1", "line turned", [] { return aimed(twisted(askew(usual_place()))); });
    rows.add("REV-3", "line turned, edges", [] { return at_edges(twisted(askew(usual_place()))); });
    for (const NamedProfile& curve : curves()) {
        for (const int exponent : {3, 7}) {
            rows.add("REV-4", curve.name + ", " + power_of_ten(exponent) + " sizes away", [=] {
                return from_afar({askew(usual_place()), curve.profile, Sector(290)},
                                 std::pow(10, exponent));
            });
        }
        rows.add("REV-4", curve.name + " at 3e5", [=] {
            return aimed({askew(far_place()), curve.profile, Sector(290)});
        });
        for (const int exponent : {4, 8}) {
            rows.add("REV-2", curve.name + ", condition " + power_of_ten(exponent), [=] {
                return aimed({of_condition(std::pow(10, exponent)), curve.profile, Sector(290)});
            });
        }
    }
    return rows.take();
}

}  // namespace etalon::hard
