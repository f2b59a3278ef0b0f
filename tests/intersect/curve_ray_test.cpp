// Rays in the spaces of curves, and which of them surely miss.
#include "core/intersect/shapes/curve_ray.h"

#include "core/intersect/shapes/curve_passage.h"
#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// A part of a curve, bent by up to `bend`, under a random map.
Curve random_curve(Random& random, double bend) {
    BezierCurve c{};
    for (std::size_t i = 0; i < 4; ++i) {
        c.points[i] =
            Vec3f(Vec3(2.0 * static_cast<double>(i) / 3 - 1, 0, 0) + random.in_cube(bend));
    }
    const auto width = static_cast<float>(random.magnitude(-4, -1));
    c.widths = {width, random.sign() > 0 ? width : 0.5F * width};
    const double size = random.magnitude(-3, 3), stretch = random.magnitude(0, 3);
    const Affine map{size * random.direction(), size * random.direction(),
                     size * stretch * random.direction(), random.in_cube(100)};
    return {c, map, {static_cast<std::uint32_t>(random.index(8)), 8}};
}

/// Returns a ray from up to 2^20 curves away that passes the curve next to half its width away, and
/// often nearly along it.
Ray grazing_ray(Random& random, const StoredCurve& c) {
    const CubicPoints part = part_points(c);
    const double u = random.uniform(c.part.begin(), c.part.end());
    const Vec3 at = blossom(points_of(c.curve), u, u, u), chord = part[3] - part[0];
    const double turn = std::ldexp(1, -static_cast<int>(random.index(40)));
    const Vec3 d = normalized(normalized(chord) + turn * random.direction());
    const double off = random.sign() * std::ldexp(1, 2 - static_cast<int>(random.index(52)));
    const Vec3 across = normalized(d.cross(chord));
    const Vec3 aim = at + 0.5 * std::abs(width_at(c.curve, u)) * (1 + off) * random.sign() * across;
    const double distance = std::ldexp(1, static_cast<int>(random.index(20)));
    const Affine& map = c.place.to_world;
    const Vec3 direction = map.vector(d);
    return {map.point(aim) - distance * direction, direction};
}

bool passes_a_piece(const StoredCurve& c, const Ray& ray) {
    const CubicPoints part = part_points(c);
    const CurveView view(CurveRay(c, part, ray), part);
    bool found = false;
    const auto take = [&](const CurvePassage&) { found = true; };
    CurvePassages(c, part, view, take).find();
    return found;
}

}  // namespace

TEST_CASE("Curve: given a ray that surely passes beside it, then it passes no piece of it") {
    Random random(11);
    for (const double bend : {0.0, 1e-6, 0.01, 0.5}) {
        int passing = 0, beside = 0, missing = 0;
        for (int i = 0; i < 50000; ++i) {
            CurveList list;
            list.push_back(random_curve(random, bend));
            const StoredCurve c = list[0];
            if (!c.place.exists()) continue;
            const Ray ray = grazing_ray(random, c);
            const CubicPoints part = part_points(c);
            const double reach = 0.5 * widest(c.curve, c.part.begin(), c.part.end());
            const bool is_beside = CurveRay(c, part, ray).passes_beside(part, reach);
            const bool passes = passes_a_piece(c, ray);
            CAPTURE(bend, i);
            REQUIRE_FALSE((is_beside && passes));
            passing += passes;
            beside += is_beside;
            missing += !passes;
        }
        CHECK(passing > 5000);
        CHECK(beside > missing / 20);
    }
}
