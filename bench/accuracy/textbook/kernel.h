// Common part of the textbook kernels. A kernel is a struct that is made from a shape, whose
// numbers it rounds to its own type, and has
//
//   using RayForm = ...;                        the ray type that it takes: see RayBlock
//   Real first_hit(const RayForm& ray) const;   the smallest t in the ray's interval, or NaN
//
// Both sides of a surface are visible. The kernels are as published, including their faults, as the
// baseline for the project's kernels.
#pragma once

#include <string_view>
#include <tuple>
#include <type_traits>

#include "bench/accuracy/tracer.h"

namespace etalon::accuracy {

template <class Real>
using Vec = Imath::Vec3<Real>;

/// Ray without precomputed data.
template <class Real>
using PlainRay = std::conditional_t<std::is_same_v<Real, float>, FloatRay, Ray>;

template <class Real>
inline constexpr Real no_root = std::numeric_limits<Real>::quiet_NaN();

template <class Real, class RayForm>
bool contains(const RayForm& ray, Real t) {
    return t > ray.tmin && t <= ray.tmax;
}

/// Returns the first of two roots, near <= far, that is in the ray's interval.
template <class Real, class RayForm>
Real first_within(const RayForm& ray, Real near, Real far) {
    if (contains(ray, near)) return near;
    return contains(ray, far) ? far : no_root<Real>;
}

/// A kernel with its name in the report.
template <class Kernel>
struct Named {
    std::string_view name;
    Kernel kernel;
};
template <class Kernel>
Named(const char*, Kernel) -> Named<Kernel>;

}  // namespace etalon::accuracy
