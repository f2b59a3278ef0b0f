#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"
#include "core/test_rays/frustum.h"

namespace etalon::hard {
namespace {

Cone oblique() {
    const Vec3 base = usual_place();
    return {base, rounded(base + tilted(0, 0, 21.4)), 1, 1};
}

const Cone along_x{{0, 0, 0}, {4, 0, 0}, 1, 1};

/// Rays to points displaced from the axis, perpendicular to it, by up to 1.2 radii.
CaseSetup far_away(const Frustum& f, double distance) {
    return only(f.cone(), 1, [=](Random& random) {
        const Vec3 d = random.direction();
        const double s = random.uniform(-0.05, 1.05);
        const Vec3 target = f.point(s, 0, 0) + 1.2 * in_disc(d, random);
        return Ray{target - (1 + distance) * d, d};
    });
}

/// Rays whose least distance from the axis is 1 +- `gap` radii.
CaseSetup tangent(const Frustum& f, double gap) {
    return only(f.cone(), 1, [=](Random& random) {
        const Vec3 d = random.direction();
        const Vec3 side = d.cross(f.axis()).normalized();
        const double s = random.uniform(0.1, 0.9), sign = random.sign();
        const double reach = 1 + sign * gap, distance = random.uniform(1, 10);
        return Ray{f.point(s, 0, 0) + reach * side - distance * d, d};
    });
}

/// Rays through a point of the surface, with directions tilted from the axis by `tilt`.
CaseSetup tilted_by(const Frustum& f, double tilt) {
    return only(f.cone(), 1, [=](Random& random) {
        const double s = random.uniform(), angle = random.uniform(0, turn);
        const Vec3 d = f.axis() + tilt * across(f.axis(), random.uniform(0, turn));
        const double back = random.uniform(0, f.length());
        return Ray{f.point(s, 1, angle) - back * d, random.sign() * d};
    });
}

/// Rays exactly parallel to the axis: inside, outside and on the surface itself.
CaseSetup parallel() {
    return only(along_x, 1, [](Random& random) {
        const double radii[] = {0, 0.5, 1, 1 - 0x1p-53, 1 + 0x1p-52, 1.5};
        const double radius = radii[random.index(std::size(radii))], x = random.uniform(-2, 6);
        const bool flat = random.index(2) == 0;
        const Vec3 from(x, flat ? radius : 0, flat ? 0 : -radius);
        return Ray{from, {random.sign(), 0, 0}};
    });
}

/// Rays at an end of the lateral surface, with targets displaced along the axis by up to `gap`
/// lengths.
CaseSetup rims(const Frustum& f, double gap) {
    return only(f.cone(), 1, [=](Random& random) {
        const double end = random.index(2) == 0 ? 0 : 1, off = random.sign() * gap;
        const Vec3 target = f.point(end + off, 1, random.uniform(0, turn));
        return towards(f.point(0.5, 0, 0) + 30.0 * in_ball(random), target);
    });
}

}  // namespace

std::vector<HardCase> cylinder_cases() {
    const Frustum f(oblique());
    Rows rows("cone");
    for (int k = 0; k <= 7; ++k) {
        rows.add_both("CYL-1", power_of_ten(k) + " radii",
                      [=] { return far_away(f, std::pow(10.0, k)); });
    }
    for (const int j : {10, 17, 24}) {
        rows.add_both("CYL-2", power_of_two(-j), [=] { return tangent(f, std::ldexp(1.0, -j)); });
    }
    for (const int j : {30, 40, 50}) {
        rows.add("CYL-2", power_of_two(-j), [=] { return tangent(f, std::ldexp(1.0, -j)); });
    }
    for (const int k : {1, 3, 5, 7}) {
        rows.add_both("CYL-3", "tilt " + power_of_ten(-k),
                      [=] { return tilted_by(f, std::pow(10.0, -k)); });
    }
    for (const int k : {10, 13, 16}) {
        rows.add("CYL-3", "tilt " + power_of_ten(-k),
                 [=] { return tilted_by(f, std::pow(10.0, -k)); });
    }
    rows.add("CYL-3", "parallel to the axis", parallel);
    for (const int k : {1, 4, 7}) {
        rows.add_both("CYL-4", power_of_ten(-k), [=] { return rims(f, std::pow(10.0, -k)); });
    }
    for (const int k : {10, 13, 16}) {
        rows.add("CYL-4", power_of_ten(-k), [=] { return rims(f, std::pow(10.0, -k)); });
    }
    return rows.take();
}

}  // namespace etalon::hard
