#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"
#include "core/test_rays/frustum.h"

namespace etalon::hard {
namespace {

Cone oblique(double length, double base_radius, double top_radius) {
    const Vec3 base = usual_place();
    return {base, rounded(base + tilted(0, 0, length)), base_radius, top_radius};
}

/// Rays that pass the apex at a distance of `gap`, on all sides.
CaseSetup apex(double gap) {
    const Frustum f(oblique(2, 1, 0));
    return only(f.cone(), 1, [=](Random& random) {
        const Vec3 target = f.cone().top + gap * in_ball(random);
        const double distance = random.magnitude(-1, 2);
        return towards(target + distance * random.direction(), target);
    });
}

/// Apex and rays with small integer coordinates: every line goes exactly through the apex.
CaseSetup exact_apex() {
    return only(Cone{{0, 0, -4}, {0, 0, 0}, 3, 0}, 3, [](Random& random) {
        const Vec3 v = 8.0 * random.in_cube();
        const Vec3 origin(std::round(v.x), std::round(v.y), 1 + std::round(std::abs(v.z)));
        return Ray{random.sign() * origin, -origin};
    });
}

/// Rays to random points of the surface or its silhouette, from up to a hundred radii away.
CaseSetup seen_from_around(const Cone& cone, double size) {
    const Frustum f(cone);
    return only(cone, size, [=](Random& random) {
        const double distance = random.magnitude(0.3, 2);
        const Vec3 origin = f.point(0.5, 0, 0) + distance * size * random.direction();
        const double s = random.uniform(), reach = nearly_one(-9, random), side = random.sign();
        if (random.index(2) == 0) return towards(origin, f.silhouette(s, reach, origin, side));
        return towards(origin, f.point(s, 1, random.uniform(0, turn)));
    });
}

/// Rays nearly along a generator: directions deviate by up to `gap`, and origins are less than a
/// third of that above or below the surface.
CaseSetup generators(const Cone& cone, double gap) {
    const Frustum f(cone);
    return only(cone, 1, [=](Random& random) {
        const double angle = random.uniform(0, turn), above = gap * random.uniform(-0.3, 0.3);
        const Vec3 along = f.point(1, 1, angle) - f.point(0, 1, angle);
        const Vec3 origin = f.point(random.uniform(-0.5, 0.5), 1, angle) + above * f.normal(angle);
        const Vec3 direction = along + gap * random.in_cube();
        return Ray{origin, direction};
    });
}

/// Rays to points of the surface, from outside or from within the convex hull.
CaseSetup arriving(const Cone& cone, bool from_inside) {
    const Frustum f(cone);
    return only(cone, f.length(), [=](Random& random) {
        const double s = random.uniform(0.01, 0.99), angle = random.uniform(0, turn);
        const Vec3 target = f.point(s, 1, angle);
        if (from_inside) {
            const double height = random.uniform(0.01, 0.99), reach = random.uniform(0, 0.95);
            return towards(f.point(height, reach, random.uniform(0, turn)), target);
        }
        Vec3 out = random.direction();
        const double cosine = out.dot(f.normal(angle));
        if (cosine < 0) out -= 2 * cosine * f.normal(angle);
        return towards(target + random.uniform(0.1, 10) * out, target);
    });
}

void add_shapes(Rows& rows) {
    for (const int j : {0, 10, 20}) {
        rows.add_both("CON-2", power_of_two(-j),
                      [j] { return seen_from_around(oblique(3, 1, 1 + std::ldexp(1.0, -j)), 1); });
    }
    for (const int j : {30, 40, 52}) {
        rows.add("CON-2", power_of_two(-j),
                 [j] { return seen_from_around(oblique(3, 1, 1 + std::ldexp(1.0, -j)), 1); });
    }
    for (const int k : {2, 4, 6, 9, 12}) {
        const double length = static_cast<float>(std::pow(10.0, -k));
        const Cone flat{{0, 0, 0}, {0, 0, length}, 1, 0.25};
        rows.add_both("CON-4", "length " + power_of_ten(-k),
                      [flat] { return seen_from_around(flat, 1); });
    }
}

void add_spawned(Rows& rows) {
    struct Spawner {
        const char* name;
        Cone cone;
    };
    const Vec3 far = far_place();
    for (const Spawner& s : {Spawner{"cylinder", oblique(3, 1, 1)},
                             Spawner{"cylinder at 3e5", {far, far + tilted(0, 0, 3), 1, 1}},
                             Spawner{"cone", oblique(3, 1, 0)},
                             Spawner{"cone at 3e5", {far, far + tilted(0, 0, 3), 2, 0}},
                             Spawner{"truncated cone", oblique(3, 0.5, 1.5)},
                             Spawner{"flat cone", oblique(1e-4, 1, 0)}}) {
        for (const bool inside : {false, true}) {
            const std::string name = s.name + std::string(inside ? ", inside" : ", outside");
            const Cone cone = s.cone;
            rows.add(
                "SPN-1", name, [=] { return arriving(cone, inside); }, Criterion::spawned);
        }
    }
}

}  // namespace

std::vector<HardCase> cone_cases() {
    Rows rows("cone");
    for (const int k : {1, 3, 6}) {
        rows.add_both("CON-1", power_of_ten(-k), [k] { return apex(std::pow(10.0, -k)); });
    }
    for (const int k : {10, 12, 14}) {
        rows.add("CON-1", power_of_ten(-k), [k] { return apex(std::pow(10.0, -k)); });
    }
    rows.add_both("CON-1", "exactly through it", exact_apex);
    for (const int k : {1, 3, 6}) {
        rows.add_both("CON-3", power_of_ten(-k),
                      [k] { return generators(oblique(3, 1, 0.25), std::pow(10.0, -k)); });
    }
    for (const int k : {10, 14}) {
        rows.add("CON-3", power_of_ten(-k),
                 [k] { return generators(oblique(3, 1, 0.25), std::pow(10.0, -k)); });
    }
    rows.add("CON-3", "on the surface", [] { return generators(oblique(3, 1, 0.25), 0); });
    add_shapes(rows);
    add_spawned(rows);
    return rows.take();
}

}  // namespace etalon::hard
