#include "core/intersect/shapes/quadric.h"

#include "core/numerics/rounding.h"
#include "core/scene/quadric_form.h"

namespace etalon {
namespace {

using RealForm = QuadricForm<double>;

/// Returns the longest row of the form's matrix: the direction across a double plane, whose form
/// has no slope.
Vec3 steepest_row(const RealForm& form) {
    Vec3 steepest(0);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Vec3 row = form.times_matrix(axis);
        if (max_abs(row) > max_abs(steepest)) steepest = row;
    }
    return steepest;
}

/// The form at a point relative to the centre, and the sums of its terms' magnitudes.
struct Evaluation {
    Evaluation(const Quadric& s, const Vec3& w) {
        const auto line = RealForm(s.coefficients).on_line(w, Vec3(0));
        const auto terms = RealForm(magnitudes_of(s.coefficients)).on_line(abs(w), Vec3(0));
        value = line.C;
        slope = line.slope;
        error_bound = 10 * unit_roundoff * terms.C;
        error_bound_of_slope = 16 * unit_roundoff * max_abs(terms.slope);
    }

    bool is_flat() const { return !(max_abs(slope) > error_bound_of_slope); }

    double value, error_bound;
    Vec3 slope;
    double error_bound_of_slope;
};

/// Moves a point down the slope onto the surface (Newton's method), as far as roundings allow.
Vec3 refined(const Quadric& s, Vec3 w) {
    for (int step = 0; step < 4; ++step) {
        const Evaluation at(s, w);
        if (std::abs(at.value) <= at.error_bound || at.is_flat()) break;
        const double unit = power_of_two_reciprocal(max_abs(at.slope));
        const Vec3 slope = unit * at.slope;  // scaled, as its square may overflow or underflow
        w -= unit * at.value / (2 * slope.dot(slope)) * slope;
    }
    return w;
}

}  // namespace

/// The form at the point may differ from zero by twice the error bound: half of it as computed,
/// half by rounding. So the surface is no further away than the error bound divided by the slope,
/// which is half the gradient; where there is no slope to speak of, as on a double plane, the form
/// grows with the square of the distance. The result is doubled, so that the kernel sees the
/// difference.
SurfacePoint surface(const Geometry&, const Quadric& s, const RayQuery& q, double t) {
    const Vec3 w = refined(s, (q.ray.origin - s.centre) + t * q.ray.direction);
    const Evaluation at(s, w);
    const Vec3 row = steepest_row(RealForm(s.coefficients));
    const Vec3 normal = unit_vector(at.is_flat() ? row : at.slope), position = s.centre + w;
    const double by_slope = at.error_bound / max_abs(at.slope);
    const double off = std::min(std::sqrt(at.error_bound / max_abs(row)), by_slope);
    const Vec3 error = position_error(abs(position) + abs(s.centre), 0) + Vec3(2 * off);
    return {position, error, normal, normal};
}

}  // namespace etalon
