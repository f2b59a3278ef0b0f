#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {
namespace {

Ring oblique(double inner, double outer) {
    return {usual_place(), rounded({1.7, 1.1, 0.7}), inner, outer};
}

/// Returns a ray to a point at `radius` from the centre, from up to 10^farthest times the ring's
/// size away.
Ray at_circle(const Ring& ring, double radius, double farthest, Random& random) {
    const Vec3 side = across(ring.normal.normalized(), random.uniform(0, turn));
    const Vec3 target = ring.centre + radius * side;
    const double distance = ring.outer * random.magnitude(-1, farthest);
    return towards(target + distance * random.direction(), target);
}

/// Rays that pass either circle at distances from far below a rounding error to a tenth of its
/// radius.
CaseSetup rims(const Ring& ring, double farthest) {
    return only(ring, ring.outer, [=](Random& random) {
        const double rim = random.index(2) == 0 ? ring.inner : ring.outer;
        return at_circle(ring, rim * nearly_one(to_the_last_bit, random), farthest, random);
    });
}

/// Rays between the circles, inside the inner and outside the outer one.
CaseSetup seen_from(const Ring& ring, double distance) {
    return only(ring, ring.outer, [=](Random& random) {
        const Vec3 n = ring.normal.normalized();
        const double width = ring.outer - ring.inner;
        const double radius = ring.inner + width * random.uniform(-0.5, 1.5);
        const Vec3 target = ring.centre + radius * across(n, random.uniform(0, turn));
        return towards(target + distance * ring.outer * random.direction(), target);
    });
}

/// Rays with small integer coordinates to points exactly on a circle, or one rounding error away.
CaseSetup exact_points(const Ring& ring) {
    static constexpr std::array corners = {Vec3(3, 4, 0), Vec3(-4, 3, 0), Vec3(5, 0, 0),
                                           Vec3(0, -5, 0)};
    return only(ring, ring.outer, [](Random& random) {
        const Vec3 target = corners[random.index(corners.size())];
        const Vec3 v = 8.0 * random.in_cube();
        Vec3 d(std::round(v.x), std::round(v.y), random.sign() * (1 + std::round(std::abs(v.z))));
        const Ray exact{target - d, d};
        if (random.index(2) == 0) return exact;
        return Ray{exact.origin, d + Vec3(random.sign() * 0x1p-49, 0, 0)};
    });
}

/// One ring in the hole of another; all rays go through the circle that they share.
CaseSetup abutting() {
    const Ring inner = oblique(0, 1), outer = oblique(1, 2);
    CaseSetup setup{{}, 2, [=](Random& random) {
                        const double radius = nearly_one(to_the_last_bit, random);
                        return at_circle(inner, radius, 4, random);
                    }};
    setup.scene.geometry.add(outer, 0);
    setup.scene.geometry.add(inner, 0);
    return setup;
}

}  // namespace

std::vector<HardCase> ring_cases() {
    const Ring usual = oblique(0.5, 1), wide = oblique(1e6 - 0.125, 1e6);
    const Ring far{far_place(), rounded(tilted(0, 0.3, 3)), 0.5, 2};
    Rows rows("ring");
    for (const int k : {0, 3, 7}) {
        rows.add_both("RNG-1", power_of_ten(k) + " radii",
                      [=] { return seen_from(usual, std::pow(10.0, k)); });
    }
    rows.add_both("RNG-1", "rims", [=] { return rims(usual, 4); });
    rows.add_both("RNG-1", "rims, at 3e5", [=] { return rims(far, 4); });
    rows.add_both("RNG-1", "rims, no hole", [] { return rims(oblique(0, 1), 4); });
    rows.add_both("RNG-1", "rims, 1e6 wide, 2^-23 of that", [=] { return rims(wide, 1); });
    const Ring level{{0, 0, 0}, {0, 0, 1}, 5, 5};
    rows.add("RNG-1", "one circle, points exactly on it", [=] { return exact_points(level); });
    rows.add("RNG-1", "inner circle, points exactly on it", [=] {
        return exact_points({level.centre, level.normal, 5, 8});
    });
    return rows.take();
}

std::vector<HardCase> ring_pair_cases() {
    Rows rows("scene");
    rows.add("RNG-1", "a ring in another's hole", abutting, Criterion::enclosed);
    return rows.take();
}

}  // namespace etalon::hard
