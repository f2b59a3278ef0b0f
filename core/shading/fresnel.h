#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// How light meets the border between two transparent media.
struct FresnelTerms {
    double reflectance;  ///< reflectance of unpolarised light; 1 where it is totally reflected
    double cos_refracted;
    bool total;
};

/// Fresnel equations; eta = n_here / n_beyond; cos_incident in [0, 1].
FresnelTerms fresnel_dielectric(double eta, double cos_incident);

/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering": the same border with
/// an approximate reflectance, taken at the angle in the thinner medium.
FresnelTerms fresnel_schlick(double eta, double cos_incident);

inline Vec3 reflect(const Vec3& direction, const Vec3& normal) {
    return direction - 2 * direction.dot(normal) * normal;
}

/// Snell's law for unit vectors; `normal` against the direction.
inline Vec3 refract(const Vec3& direction, const Vec3& normal, double eta, double cos_incident,
                    double cos_refracted) {
    return eta * direction + (eta * cos_incident - cos_refracted) * normal;
}

}  // namespace etalon
