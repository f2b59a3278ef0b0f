#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {
namespace {

const Sphere unit_sphere{usual_place(), 1};

/// Rays whose closest point to the centre is uniformly distributed in a disc of 1.2 radii: 69 of
/// 100 hit.
Ray from_afar(const Sphere& s, double distance, Random& random) {
    const Vec3 d = random.direction();
    const Vec3 closest = s.centre + 1.2 * s.radius * in_disc(d, random);
    return {closest - s.radius * (1 + distance) * d, d};
}

CaseSetup far_away(const Sphere& s, double distance) {
    return only(s, s.radius, [=](Random& random) { return from_afar(s, distance, random); });
}

/// Rays from `height` radii above the surface to random points inside.
CaseSetup close_to(const Sphere& s, double height) {
    return only(s, s.radius, [=](Random& random) {
        const Vec3 up = random.direction();
        const Vec3 inside = 0.9 * in_ball(random);
        return towards(s.centre + s.radius * (1 + height) * up, s.centre + s.radius * inside);
    });
}

/// Rays from `height` above a planet's pole towards the horizon and, relatively, 1e-12 to 1e-1
/// above or below it. The horizon is where the cosine of the dip is r / (r + h).
CaseSetup planet(double radius, double height) {
    const Sphere s{{0, 0, -radius}, radius};
    const double dip = std::asin(std::sqrt(height * (2 * radius + height)) / (radius + height));
    return only(s, radius, [=](Random& random) {
        const double sign = random.sign();
        const double down = dip * (1 + sign * random.magnitude(-12, -1));
        const Vec3 level = across({0, 0, 1}, random.uniform(0, turn));
        return Ray{{0, 0, height}, std::cos(down) * level - Vec3(0, 0, std::sin(down))};
    });
}

/// Rays whose closest point to the centre is 1 +- `gap` radii from it; they start a few radii away.
CaseSetup grazing(const Sphere& s, double gap) {
    return only(s, s.radius, [=](Random& random) {
        const Vec3 d = random.direction();
        const Vec3 side = across(d, random.uniform(0, turn));
        const double sign = random.sign(), distance = random.uniform(1, 10);
        const double reach = s.radius * (1 + sign * gap);
        return Ray{s.centre + reach * side - s.radius * distance * d, d};
    });
}

/// Rays along an axis, 1 + k 2^-52 radii from the centre, -4 <= k <= 4: every number is exact, and
/// some of the lines are tangents.
CaseSetup tangent() {
    return only(Sphere{{0, 0, 0}, 1}, 1, [](Random& random) {
        const int along = random.axis();
        const int side = (along + 1 + static_cast<int>(random.index(2))) % 3;
        Vec3 origin(0), direction(0);
        direction[along] = random.sign();
        origin -= std::ldexp(1.0, static_cast<int>(random.index(24))) * direction;
        const double steps = static_cast<double>(random.index(9)) - 4;
        origin[side] = random.sign() * (1 + steps * 0x1p-52);
        return Ray{origin, direction};
    });
}

/// Rays to a point of the surface, half of them from outside and half from inside.
CaseSetup arriving(double radius, double offset) {
    const Sphere s{offset * Vec3(0.6, -0.48, 0.64), radius};
    return only(s, radius, [=](Random& random) {
        const double distance =
            random.index(2) == 0 ? random.uniform(0, 0.95) : random.uniform(1.05, 4);
        const Vec3 origin = s.centre + radius * distance * random.direction();
        return towards(origin, s.centre + radius * random.direction());
    });
}

/// A slightly larger shell around a sphere, hit from all sides.
CaseSetup shells(Sides inner_sides) {
    const Sphere outer{unit_sphere.centre, 1 + 0x1p-20};
    CaseSetup setup{{}, 1, [=](Random& random) {
                        const Vec3 d = random.direction();
                        const double reach = random.index(2) == 0
                                                 ? random.uniform()
                                                 : nearly_one(to_the_last_bit, random);
                        const double distance = random.uniform(-1, 10);
                        const Vec3 side = across(d, random.uniform(0, turn));
                        return Ray{unit_sphere.centre + reach * side - distance * d, d};
                    }};
    setup.scene.geometry.add(outer, 0);
    setup.scene.geometry.add(unit_sphere, 0, inner_sides);
    return setup;
}

/// The default sphere and its rays scaled by `scale`; half of the directions are scaled, too.
CaseSetup scaled(double scale) {
    const auto size = static_cast<double>(static_cast<float>(scale));
    const Sphere s{rounded(size * unit_sphere.centre), size};
    return only(s, size, [=](Random& random) {
        Ray ray = from_afar(s, 10, random);
        if (random.index(2) == 0) ray.direction *= size;
        return ray;
    });
}

/// Rays from the centre, or from at most a millionth of a radius beside it.
CaseSetup from_centre(const Sphere& s, bool exactly) {
    return only(s, s.radius, [=](Random& random) {
        const double miss = exactly ? 0 : random.magnitude(-18, -6);
        const Vec3 origin = s.centre + miss * s.radius * random.direction();
        const double length = random.magnitude(-6, 6);
        return Ray{origin, length * random.direction()};
    });
}

void add_distances(Rows& rows) {
    for (int k = 0; k <= 7; ++k) {
        rows.add_both("SPH-1", power_of_ten(k) + " radii",
                      [k] { return far_away(unit_sphere, std::pow(10.0, k)); });
    }
    for (const int k : {1, 2, 3, 4, 5, 6, 7}) {
        rows.add_both("SPH-2", power_of_ten(-k) + " radii",
                      [k] { return close_to(unit_sphere, std::pow(10.0, -k)); });
    }
    for (const int k : {10, 13, 15}) {
        rows.add("SPH-2", power_of_ten(-k) + " radii",
                 [k] { return close_to(unit_sphere, std::pow(10.0, -k)); });
    }
}

void add_grazing(Rows& rows) {
    for (const int radius : {1'000'000, 6'400'000}) {
        for (const int k : {-3, 0, 3}) {
            const std::string variant =
                std::to_string(radius) + " wide, " + power_of_ten(k) + " up";
            rows.add_both("SPH-3", variant,
                          [=] { return planet(radius, static_cast<float>(std::pow(10.0, k))); });
        }
    }
    for (int j = 1; j <= 8; ++j) {
        rows.add_both("SPH-4", power_of_ten(-j),
                      [j] { return grazing(unit_sphere, std::pow(10.0, -j)); });
    }
    for (const int j : {30, 35, 40, 45, 50}) {
        rows.add("SPH-4", power_of_two(-j),
                 [j] { return grazing(unit_sphere, std::ldexp(1.0, -j)); });
    }
    rows.add("SPH-4", "tangents along the axes", tangent);
}

void add_spawned(Rows& rows) {
    struct Place {
        const char* variant;
        double radius, offset;
    };
    for (const Place& p : {Place{"radius 1", 1, 0}, Place{"radius 1 at 1e2", 1, 1e2},
                           Place{"radius 1 at 1e4", 1, 1e4}, Place{"radius 1 at 1e6", 1, 1e6},
                           Place{"radius 1e-3", 1e-3, 0}, Place{"radius 1e3", 1e3, 0},
                           Place{"radius 1e6", 1e6, 0}}) {
        rows.add(
            "SPH-5", p.variant, [p] { return arriving(p.radius, p.offset); }, Criterion::spawned);
    }
}

void add_places(Rows& rows) {
    for (const int k : {-30, -20, 19, 30}) {
        rows.add_both("SPH-7", "scale " + power_of_ten(k),
                      [k] { return scaled(std::pow(10.0, k)); });
    }
    for (int k = 0; k <= 7; ++k) {
        const Sphere s{rounded(std::pow(10.0, k) * Vec3(1, 0.3, 0.9)), 1};
        rows.add_both("SPH-8", "offset " + power_of_ten(k), [s] { return far_away(s, 10); });
    }
    rows.add_both("SPH-9", "from the centre", [] { return from_centre(unit_sphere, true); });
    rows.add("SPH-9", "from beside the centre", [] { return from_centre(unit_sphere, false); });
}

}  // namespace

std::vector<HardCase> sphere_cases() {
    Rows rows("sphere");
    add_distances(rows);
    add_grazing(rows);
    add_spawned(rows);
    add_places(rows);
    return rows.take();
}

std::vector<HardCase> shell_cases() {
    Rows rows("scene");
    rows.add_both("SPH-6", "shells 2^-20 apart", [] { return shells(Sides::both); });
    rows.add_both("SPH-6", "inner shell hollow", [] { return shells(Sides::back); });
    return rows.take();
}

}  // namespace etalon::hard
