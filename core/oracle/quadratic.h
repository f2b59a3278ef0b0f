#pragma once

#include <array>

#include "core/oracle/tracked.h"

namespace etalon::definition {

/// A root of A t^2 + 2 B t + C, and whether the form decreases there: then the line enters the
/// inside, where the form is negative.
struct Root {
    Tracked t;
    Certainty exists, falling;
};
struct Roots {
    std::array<Root, 2> list;
    std::size_t count = 0;
};

/// Returns the roots of the quadratic, with what is known of them.
Roots solve(const Tracked& a, const Tracked& b, const Tracked& c);

}  // namespace etalon::definition
