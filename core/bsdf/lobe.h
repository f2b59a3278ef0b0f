#pragma once

#include <variant>

#include "core/bsdf/diffuse.h"
#include "core/bsdf/fresnel_blend.h"
#include "core/bsdf/microfacet_reflection.h"
#include "core/bsdf/microfacet_transmission.h"
#include "core/bsdf/oren_nayar.h"
#include "core/bsdf/specular.h"

namespace etalon {

/// One way in which a surface scatters light; lobe_kind.h says what each offers.
using Lobe = std::variant<LambertReflection, LambertTransmission, OrenNayarReflection,
                          SpecularReflection, SpecularTransmission, FresnelSpecular,
                          MicrofacetReflection, MicrofacetTransmission, FresnelBlend>;

}  // namespace etalon
