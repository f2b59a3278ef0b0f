#pragma once

#include "core/bsdf/fresnel.h"
#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

/// Estimate of the mean of Fresnel's terms over the facets visible from `wo`. Those are turned to
/// the eye the more, the more the eye grazes the surface and the rougher that is; terms are taken
/// on both sides of the mean cosine, as total reflection begins at once. Fitted by eye to integrals
/// for alpha from 0.05 to 1.6, of which it is mostly within a third.
Color mean_reflectance(const Fresnel& fresnel, const TrowbridgeReitz& facets, const Vec3f& wo);

}  // namespace etalon
