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

/// Lobes of single materials. They are a union in the union, so that the others are few enough to
/// be told apart by a switch (of up to eleven, as the standard library of GCC has it).
using RareLobe = std::variant<HairScattering, DisneyBase, DisneyGloss, DisneyTransmission,
                              DisneyClearcoat, DiffuseExit, FourierScattering>;

/// One way in which a surface scatters light; lobe_kind.h says what each offers.
using Lobe = std::variant<LambertReflection, LambertTransmission, OrenNayarReflection,
                          SpecularReflection, SpecularTransmission, FresnelSpecular,
                          MicrofacetReflection, MicrofacetTransmission, FresnelBlend, RareLobe>;

// A rare lobe makes no list of lobes longer.
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
