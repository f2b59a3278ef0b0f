#include "core/intersect/shapes/affine_exact.h"

#include "core/intersect/shapes/exact_line.h"
#include "core/intersect/shapes/exact_quadratic.h"

namespace etalon {
namespace {

constexpr int in = ExactQuadratic::in, out = ExactQuadratic::out;

/// Returns the place of a root of the side: -1 below the base, 0 between the caps or on one, 1
/// above the top.
int place(const ExactQuadratic& side, int way, const ExactLine& line) {
    if (side.sign_at_root(way, line.w[2], line.d[2]) < 0) return -1;
    return side.sign_at_root(way, line.w[2] - line.unit, line.d[2]) > 0 ? 1 : 0;
}

/// Returns the root of the linear term: -start / rise.
double root(const Dyadic& start, const Dyadic& rise) {
    return -start.sign() * rise.sign() * static_cast<double>(start.magnitude() / rise.magnitude());
}

/// Returns the passage between the caps of a line parallel to the axis.
Passage between_caps(const ExactLine& line) {
    const double base = root(line.w[2], line.d[2]), top = root(line.w[2] - line.unit, line.d[2]);
    return line.d[2].sign() > 0 ? Passage{base, top} : Passage{top, base};
}

}  // namespace

Passage exact_passage(const Ellipsoid& e, const Ray& ray) {
    if (!e.frame.exists() || !is_finite(ray.origin) || !is_finite(ray.direction)) return {};
    const ExactLine line(e.to_world, ray);
    const ExactQuadratic form(dot(line.d, line.d), dot(line.w, line.d),
                              dot(line.w, line.w) - square(line.unit));
    if (!form.has_roots()) return {};
    return {form.root(in), form.root(out)};
}

Passage exact_passage(const ClosedCylinder& c, const Ray& ray) {
    if (!c.frame.exists() || !is_finite(ray.origin) || !is_finite(ray.direction)) return {};
    const ExactLine line(c.to_world, ray);
    const auto &w = line.w, &d = line.d;
    const Dyadic a = square(d[0]) + square(d[1]);
    const Dyadic gap = square(w[0]) + square(w[1]) - square(line.unit);
    if (a.sign() == 0) return gap.sign() <= 0 ? between_caps(line) : Passage();
    const ExactQuadratic side(a, w[0] * d[0] + w[1] * d[1], gap);
    if (!side.has_roots()) return {};
    const int entry = place(side, in, line), exit = place(side, out, line);
    if (entry == exit && entry != 0) return {};
    const auto end = [&](int where, int way) {
        if (where == 0) return side.root(way);
        return root(where < 0 ? w[2] : w[2] - line.unit, d[2]);
    };
    return {end(entry, in), end(exit, out)};
}

}  // namespace etalon
