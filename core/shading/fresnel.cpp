#include "core/shading/fresnel.h"

#include <cmath>

namespace etalon {
namespace {

/// Returns the cosine of the refracted direction, or total reflection.
FresnelTerms snell(double eta, double cos_incident) {
    const double sin2 = eta * eta * (1 - cos_incident * cos_incident);
    if (sin2 >= 1) return {1, 0, true};
    return {0, std::sqrt(1 - sin2), false};
}

}  // namespace

FresnelTerms fresnel_dielectric(double eta, double cos_incident) {
    FresnelTerms fresnel = snell(eta, cos_incident);
    if (fresnel.total) return fresnel;
    const double ci = eta * cos_incident, ct = eta * fresnel.cos_refracted;
    const double perpendicular = (ci - fresnel.cos_refracted) / (ci + fresnel.cos_refracted);
    const double parallel = (cos_incident - ct) / (cos_incident + ct);
    fresnel.reflectance = (perpendicular * perpendicular + parallel * parallel) / 2;
    return fresnel;
}

FresnelTerms fresnel_schlick(double eta, double cos_incident) {
    FresnelTerms fresnel = snell(eta, cos_incident);
    if (fresnel.total) return fresnel;
    const double normal = (eta - 1) / (eta + 1);
    const double r0 = normal * normal;
    const double cosine = eta > 1 ? fresnel.cos_refracted : cos_incident;
    fresnel.reflectance = r0 + (1 - r0) * std::pow(1 - cosine, 5);
    return fresnel;
}

}  // namespace etalon
