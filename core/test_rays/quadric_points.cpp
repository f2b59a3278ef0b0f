#include "core/test_rays/quadric_points.h"

#include <optional>

namespace etalon {
namespace {

constexpr int attempts = 16;

/// Returns a root of a t^2 + 2 b t + c between 0 and 1.
std::optional<double> root_in_unit(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const double sum = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double t : {c / sum, sum / a}) {
        if (t >= 0 && t <= 1) return t;
    }
    return std::nullopt;
}

}  // namespace

QuadricPoints::QuadricPoints(const Quadric& quadric)
    : centre_(quadric.centre), form_(quadric.coefficients), clip_(quadric.clip) {}

Vec3 QuadricPoints::in_clip(Random& random) const {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    return clip_.min + Vec3(x, y, z) * (clip_.max - clip_.min);
}

Vec3 QuadricPoints::in_face(int axis, double face, Random& random) const {
    Vec3 p = in_clip(random);
    p[axis] = face;
    return p;
}

Vec3 QuadricPoints::on_surface(Random& random) const {
    for (int i = 0; i < attempts; ++i) {
        const Vec3 a = in_clip(random), b = in_clip(random);
        const auto line = form_.on_line(a - centre_, b - a);
        if (const auto t = root_in_unit(line.A, line.B, line.C)) return a + *t * (b - a);
    }
    return in_clip(random);
}

Vec3 QuadricPoints::on_rim(Random& random) const {
    for (int i = 0; i < attempts; ++i) {
        const int axis = random.axis();
        const double face = (random.index(2) == 0 ? clip_.min : clip_.max)[axis];
        const Vec3 a = in_face(axis, face, random), b = in_face(axis, face, random);
        const auto line = form_.on_line(a - centre_, b - a);
        const auto t = root_in_unit(line.A, line.B, line.C);
        if (!t) continue;
        Vec3 p = a + *t * (b - a);
        p[axis] = face;
        return p;
    }
    return in_clip(random);
}

/// Between two points a and b of the box, where the discriminant of the lines from `from` vanishes:
/// B^2 - A C for the direction a - from + s (b - a) is a quadratic in s.
Vec3 QuadricPoints::silhouette(const Vec3& from, double off, Random& random) const {
    const Vec3 w = from - centre_;
    for (int i = 0; i < attempts; ++i) {
        const Vec3 a = in_clip(random), b = in_clip(random), step = b - a;
        const auto start = form_.on_line(w, a - from), change = form_.on_line(w, step);
        const double C = start.C, mixed = start.Md.dot(step);
        const double p = change.B * change.B - change.A * C;
        const double q = start.B * change.B - mixed * C;
        const double r = start.B * start.B - start.A * C;
        if (const auto s = root_in_unit(p, q, r)) return a + (*s + off) * step;
    }
    return in_clip(random);
}

}  // namespace etalon
