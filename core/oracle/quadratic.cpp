#include "core/oracle/quadratic.h"

namespace etalon::definition {

Roots solve(const Tracked& a, const Tracked& b, const Tracked& c) {
    Roots roots;
    if ((is_zero(a) & is_zero(b)) == Certainty::yes) return roots;  // a constant
    const Tracked discriminant = b * b - a * c;
    if (is_negative(discriminant) == Certainty::yes) return roots;
    if (is_positive(discriminant) != Certainty::yes) {
        // A tangent, or too close to one to tell: both roots are -B/A to within the unknown.
        const Quad slack = discriminant.error > 0 ? square_root(2 * discriminant.error) : Quad(0);
        const Tracked t = Tracked(-b.value, b.error + slack) / a;
        roots.list[roots.count++] = {t, !is_negative(discriminant), Certainty::unknown};
        return roots;
    }
    // A t + B is +-root at the roots; c / q is the one of the sign that B has.
    const Tracked root = square_root(discriminant);
    const bool rising = b.value > 0;
    const Tracked q = rising ? -b - root : root - b;
    roots.list[roots.count++] = {c / q, Certainty::yes, certainty(!rising)};
    // If A may be zero, the other root is beyond the reach of any bounded shape.
    if (is_zero(a) == Certainty::no)
        roots.list[roots.count++] = {q / a, Certainty::yes, certainty(rising)};
    return roots;
}

}  // namespace etalon::definition
