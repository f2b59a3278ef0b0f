#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"
#include "core/numerics/rounding.h"
#include "core/test_rays/quadric_points.h"

namespace etalon::hard {
namespace {

using Coefficients = std::array<double, 10>;

Box3 around(const Vec3& centre, double reach) {
    return {centre - Vec3(reach), centre + Vec3(reach)};
}

/// Returns a quadric about the default centre, clipped by a box with float coordinates and
/// half-extent 1.
Quadric usual(const Coefficients& c) {
    const Box3f box = round_outward(around(usual_place(), 1));
    return {usual_place(), c, {Vec3(box.min), Vec3(box.max)}};
}

constexpr Coefficients sphere = {1, 0, 0, 0, 1, 0, 0, 1, 0, -1};
constexpr Coefficients cone = {1, 0, 0, 0, 1, 0, 0, -1, 0, 0};

/// Rays from 10^low to 10^high away: a quarter each to points of the box, of the surface, of the
/// curves where the surface meets the box's faces, and to the silhouette.
CaseSetup aimed(const Quadric& s, double low, double high) {
    const QuadricPoints points(s);
    return only(s, 1, [=](Random& random) {
        const double distance = random.magnitude(low, high);
        const Vec3 origin = s.clip.center() + distance * random.direction();
        switch (random.index(4)) {
            case 0:
                return towards(origin, points.in_clip(random));
            case 1:
                return towards(origin, points.on_surface(random));
            case 2:
                return towards(origin, points.on_rim(random));
            default:
                const double off = nearly_one(to_the_last_bit, random) - 1;
                return towards(origin, points.silhouette(origin, off, random));
        }
    });
}

/// Rays that pass `centre` at a distance of up to `gap`.
CaseSetup close_to_centre(const Quadric& s, double gap) {
    return only(s, 1, [=](Random& random) {
        const Vec3 target = s.centre + gap * in_ball(random);
        return towards(target + random.magnitude(-1, 2) * random.direction(), target);
    });
}

/// Returns a ray through a point with integer coordinates, or half of the time one rounding error
/// away from it.
Ray through(const Vec3& point, Random& random) {
    const Vec3 v = 8.0 * random.in_cube();
    Vec3 d(1 + std::round(std::abs(v.x)), std::round(v.y), std::round(v.z));
    if (random.index(2) == 0) d = -d;
    const Vec3 beside(0, random.index(2) == 0 ? 0x1p-49 : 0, 0);
    return {point - d + beside, d};
}

CaseSetup exactly_through_centre(const Coefficients& c) {
    return only(Quadric{{0, 0, 0}, c, around(Vec3(0), 4)}, 4,
                [](Random& random) { return through(Vec3(0), random); });
}

/// A sphere in its tight bounding box, from inside along the axes or nearly along them.
CaseSetup touching(const Vec3& centre) {
    return only(Quadric{centre, sphere, around(centre, 1)}, 1, [=](Random& random) {
        Vec3 d = axis_direction(random);
        if (random.index(2) == 0) d += random.magnitude(to_the_last_bit, -6) * random.in_cube();
        return Ray{centre, d};
    });
}

/// A sphere of eight pieces whose boxes share the corner `at`: no ray escapes between them.
CaseSetup pieces(const Vec3& centre, const Vec3& at) {
    CaseSetup setup{{}, 1, {}};
    for (int piece = 0; piece < 8; ++piece) {
        Quadric s{centre, sphere, around(centre, 1)};
        for (int k = 0; k < 3; ++k) ((piece >> k & 1) != 0 ? s.clip.min : s.clip.max)[k] = at[k];
        setup.scene.geometry.add(s, 0);
    }
    setup.ray = [=, whole = setup.scene.geometry.all<Quadric>()](Random& random) {
        const QuadricPoints points(whole[random.index(whole.size())]);
        return towards(centre + 0.3 * random.in_cube(), points.on_rim(random));
    };
    return setup;
}

/// A sphere of radius 5 clipped at x = 3; with two `boxes` the other part is a second quadric. Rays
/// go through points with integer coordinates at x = 3, or one rounding error away from them.
CaseSetup cut_exactly(int boxes) {
    static constexpr std::array points = {Vec3(3, 4, 0), Vec3(3, 0, -4), Vec3(3, -4, 0)};
    constexpr Coefficients form = {1, 0, 0, 0, 1, 0, 0, 1, 0, -25};
    CaseSetup setup = only(Quadric{{0, 0, 0}, form, {Vec3(-5), {3, 5, 5}}}, 5, [](Random& random) {
        return through(points[random.index(points.size())], random);
    });
    if (boxes == 2) setup.scene.geometry.add(Quadric{{0, 0, 0}, form, {{3, -5, -5}, Vec3(5)}}, 0);
    return setup;
}

/// A quadric of two planes that are faces of its box, seen from between them.
CaseSetup coincident() {
    const Quadric s{{0, 0, 0}, {1, 0, 0, 0, 0, 0, 0, 0, 0, -1}, around(Vec3(0), 1)};
    return only(s, 1, [](Random& random) {
        const Vec3 origin = 0.9 * random.in_cube();
        Vec3 target = random.in_cube();
        target.x = random.sign();
        return towards(origin, target);
    });
}

/// A sphere of radius 1 with its centre at (1, -2, 0.5) times `distance` from the form's origin,
/// from which it is seen.
Quadric off_centre(double distance) {
    const Vec3 m = distance * Vec3(1, -2, 0.5);
    return {{0, 0, 0}, {1, 0, 0, -m.x, 1, 0, -m.y, 1, -m.z, m.dot(m) - 1}, around(m, 1.5)};
}

void add_degenerate(Rows& rows) {
    struct Form {
        const char* name;
        Coefficients coefficients;
    };
    for (const Form& f : {Form{"plane", {0, 0, 0, 1, 0, 0, 2, 0, 3, 0.5}},
                          Form{"two planes", {1, 0, 0, 0, 0, 0, 0, 0, 0, -0.25}},
                          Form{"crossed planes", {0, 1, 0, 0, 0, 0, 0, 0, 0, 0}},
                          Form{"double plane", {1, 1, 1, 0, 1, 1, 0, 1, 0, 0}},
                          Form{"nothing", {1, 0, 0, 0, 0, 0, 0, 0, 0, 1}},
                          Form{"cylinder", {1, 0, 0, 0, 1, 0, 0, 0, 0, -0.25}},
                          Form{"paraboloid", {1, 0, 0, 0, 1, 0, 0, 0, -0.5, 0}},
                          Form{"saddle", {1, 0, 0, 0, -1, 0, 0, 0, -0.5, 0}},
                          Form{"hyperboloid", {1, 0, 0, 0, 1, 0, 0, -1, 0, -0.25}},
                          Form{"two sheets", {-1, 0, 0, 0, -1, 0, 0, 1, 0, -0.25}}}) {
        rows.add_both("QUA-1", f.name, [c = f.coefficients] { return aimed(usual(c), -1, 4); });
    }
    rows.add("QUA-1", "a line, exactly through it", [] {
        return exactly_through_centre({1, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    });
    rows.add("QUA-1", "a point, exactly through it", [] {
        return exactly_through_centre({1, 0, 0, 0, 1, 0, 0, 1, 0, 0});
    });
    rows.add("QUA-1", "double plane, in whole numbers", [] {
        return exactly_through_centre({1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    });
    rows.add("QUA-1", "apex, exactly through it", [] { return exactly_through_centre(cone); });
    for (const int k : {1, 6, 12}) {
        rows.add("QUA-1", "apex " + power_of_ten(-k),
                 [k] { return close_to_centre(usual(cone), std::pow(10.0, -k)); });
    }
}

void add_clipped(Rows& rows) {
    rows.add_both("QUA-2", "part of a sphere", [] {
        return aimed({{0, 0, 0}, sphere, {{-1, -0.5, 0.25}, {0.5, 1, 0.75}}}, -1, 4);
    });
    rows.add_both("QUA-2", "a thin slice of a sphere", [] {
        return aimed({{0, 0, 0}, sphere, {{-1, -1, 0.25}, {1, 1, 0.25 + 0x1p-20}}}, -1, 2);
    });
    rows.add_both("QUA-2", "touching the box", [] { return aimed(usual(sphere), -1, 4); });
    rows.add(
        "QUA-2", "touching the box, along the axes", [] { return touching(Vec3(0)); },
        Criterion::enclosed);
    rows.add("QUA-2", "cut exactly where it is hit", [] { return cut_exactly(1); });
    rows.add("QUA-2", "planes that are faces of the box", coincident, Criterion::enclosed);
}

void add_conditions(Rows& rows) {
    for (const int k : {0, 1, 2, 3, 4, 5, 6}) {
        rows.add("QUA-3", "sphere seen from " + power_of_ten(k),
                 [k] { return aimed(off_centre(std::pow(10.0, k)), -1, 1); });
    }
    for (const int k : {1, 3, 5, 7}) {
        rows.add_both("QUA-3", "sphere, " + power_of_ten(k) + " radii away",
                      [k] { return aimed(usual(sphere), k, k); });
    }
}

}  // namespace

std::vector<HardCase> quadric_cases() {
    Rows rows("quadric");
    add_degenerate(rows);
    add_clipped(rows);
    add_conditions(rows);
    return rows.take();
}

std::vector<HardCase> quadric_group_cases() {
    Rows rows("scene");
    rows.add("QUA-2", "two boxes that meet exactly where it is hit", [] { return cut_exactly(2); });
    rows.add(
        "QUA-2", "a sphere in eight pieces",
        [] {
            return pieces(Vec3(0), {0.25, -0.125, 0});
        },
        Criterion::enclosed);
    rows.add(
        "QUA-2", "a sphere in eight pieces, oblique",
        [] { return pieces(usual_place(), usual_place() + Vec3(0.1, -0.2, 0.3)); },
        Criterion::enclosed);
    return rows.take();
}

}  // namespace etalon::hard
