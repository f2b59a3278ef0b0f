// A quadric and a ray in exact arithmetic: slow, and right for every finite ray.
#pragma once

#include <algorithm>

#include "core/intersect/ray.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns whether a quadric is not finite or has no surface.
inline bool is_degenerate(const Quadric& s) {
    const auto& c = s.coefficients;
    const auto is_finite_number = [](double x) { return std::isfinite(x); };
    const auto is_zero = [](double x) { return x == 0; };
    return !is_finite(s.centre) || !is_finite(s.clip.min) || !is_finite(s.clip.max) ||
           s.clip.isEmpty() || !std::all_of(c.begin(), c.end(), is_finite_number) ||
           std::all_of(c.begin(), c.end() - 1, is_zero);
}

/// Returns the first visible t; no_hit for a degenerate quadric, and for a ray that is not finite.
/// Hit and miss are exact, and t is good to a few ulp.
[[gnu::cold]] double exact_first_hit(const Quadric& s, Sides sides, const Ray& ray);

}  // namespace etalon
