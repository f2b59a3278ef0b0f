// Profile curves of the unit shapes of which surfaces of revolution are images. Those of pbrt-v3
// have its surface coordinate v.
#pragma once

#include "core/scene/revolved.h"

namespace etalon::profiles {

/// Returns the part of the unit sphere between two heights in [-1, 1].
inline Profile sphere(double low, double high) {
    return {Profile::Along::angle, {1, 0, -1}, low, high};
}

/// Returns a cylinder of radius 1 from z = 0 to z = 1.
inline Profile cylinder() {
    return {Profile::Along::height, {1, 0, 0}, 0, 1};
}

/// Returns a cone with a unit circle at z = -1 and its tip at the origin, about which nothing
/// cancels.
inline Profile cone() {
    return {Profile::Along::height, {0, 0, 1}, -1, 0};
}

/// Returns x^2 + y^2 = z between `low` >= 0 and 1.
inline Profile paraboloid(double low) {
    return {Profile::Along::height, {0, 1, 0}, low, 1};
}

/// Returns x^2 + y^2 = waist2 + widening z^2.
inline Profile hyperboloid(double waist2, double widening, double low, double high) {
    return {Profile::Along::height, {waist2, 0, widening}, low, high};
}

/// Returns the unit disk with a hole of radius `inner`.
inline Profile disk(double inner) {
    return {Profile::Along::radius, {}, inner, 1, true};
}

}  // namespace etalon::profiles
