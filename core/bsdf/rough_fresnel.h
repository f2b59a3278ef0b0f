#pragma once

#include "core/bsdf/fresnel.h"
#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

/// Returns an estimate of the mean Fresnel term over the microfacets visible from `wo`. The more
/// grazing `wo` and the rougher the surface, the more these are turned to the eye. Terms are
/// evaluated on both sides of the mean cosine, as total reflection begins abruptly. Fitted by eye
/// to integrals for alpha from 0.05 to 1.6; mostly within a third of them.
Color mean_reflectance(const Fresnel& fresnel, const TrowbridgeReitz& facets, const Vec3f& wo);

}  // namespace etalon
