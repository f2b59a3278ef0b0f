#include "core/shading/fresnel.h"

#include <cmath>

namespace etalon {
namespace {

/// The cosine beyond the border, or total reflection.
DielectricBorder snell(double eta, double cos_incident) {
    const double sin2 = eta * eta * (1 - cos_incident * cos_incident);
    if (sin2 >= 1) return {1, 0, true};
    return {0, std::sqrt(1 - sin2), false};
}

}  // namespace

DielectricBorder dielectric_border(double eta, double cos_incident) {
    DielectricBorder border = snell(eta, cos_incident);
    if (border.total) return border;
    const double ci = eta * cos_incident, ct = eta * border.cos_refracted;
    const double perpendicular = (ci - border.cos_refracted) / (ci + border.cos_refracted);
    const double parallel = (cos_incident - ct) / (cos_incident + ct);
    border.reflectance = (perpendicular * perpendicular + parallel * parallel) / 2;
    return border;
}

DielectricBorder schlick_border(double eta, double cos_incident) {
    DielectricBorder border = snell(eta, cos_incident);
    if (border.total) return border;
    const double normal = (eta - 1) / (eta + 1);
    const double r0 = normal * normal;
    const double cosine = eta > 1 ? border.cos_refracted : cos_incident;
    border.reflectance = r0 + (1 - r0) * std::pow(1 - cosine, 5);
    return border;
}

}  // namespace etalon
