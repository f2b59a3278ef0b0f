#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Reflection and refraction at the interface between two dielectrics.
struct FresnelTerms {
    double reflectance;  ///< reflectance of unpolarised light; 1 where it is totally reflected
    double cos_refracted;
    bool total;
};

/// Evaluates the Fresnel equations. Reference for LeavingRays, which computes the same in SIMD
/// lanes. eta is the index of refraction on the incident side divided by
/// that on the other side; cos_incident is in [0, 1].
FresnelTerms fresnel_dielectric(double eta, double cos_incident);

/// The same with Schlick's approximate reflectance (1994, "An Inexpensive BRDF Model for
/// Physically-based Rendering"), taken at the angle in the medium of the lower index.
FresnelTerms fresnel_schlick(double eta, double cos_incident);

inline Vec3 reflect(const Vec3& direction, const Vec3& normal) {
    return direction - 2 * direction.dot(normal) * normal;
}

/// Refracts a unit vector by Snell's law. Reference for LeavingRays, too. `normal` is a unit vector
/// with a negative dot product with `direction`.
inline Vec3 refract(const Vec3& direction, const Vec3& normal, double eta, double cos_incident,
                    double cos_refracted) {
    return eta * direction + (eta * cos_incident - cos_refracted) * normal;
}

}  // namespace etalon
