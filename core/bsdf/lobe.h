#pragma once

#include <variant>

#include "core/bsdf/diffuse.h"
#include "core/bsdf/diffuse_exit.h"
#include "core/bsdf/disney.h"
#include "core/bsdf/fourier.h"
#include "core/bsdf/fresnel_blend.h"
#include "core/bsdf/hair.h"
#include "core/bsdf/microfacet_reflection.h"
#include "core/bsdf/microfacet_transmission.h"
#include "core/bsdf/oren_nayar.h"
#include "core/bsdf/specular.h"

namespace etalon {

/// Lobes of single materials. They are a union within the union, so that the outer one has few
/// enough alternatives for a switch (up to eleven in GCC's standard library).
using RareLobe = std::variant<HairScattering, DisneyBase, DisneyGloss, DisneyTransmission,
                              DisneyClearcoat, DiffuseExit, FourierScattering>;

/// One lobe of a BSDF; lobe_kind.h describes its interface.
using Lobe = std::variant<LambertReflection, LambertTransmission, OrenNayarReflection,
                          SpecularReflection, SpecularTransmission, FresnelSpecular,
                          MicrofacetReflection, MicrofacetTransmission, FresnelBlend, RareLobe>;

// A rare lobe does not enlarge lists of lobes.
static_assert(sizeof(RareLobe) <= sizeof(MicrofacetReflection));

/// Calls visitor(lobe) with the lobe's own type.
template <class Visitor, class AnyLobe>
decltype(auto) visit_lobe(const Visitor& visitor, AnyLobe& lobe) {
    return std::visit(
        [&](auto& kind) -> decltype(auto) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(kind)>, RareLobe>) {
                return std::visit(visitor, kind);
            } else {
                return visitor(kind);
            }
        },
        lobe);
}

}  // namespace etalon
