#pragma once

#include "core/scene/physical_material.h"

namespace etalon {

/// Largest number of lobes of the BSDF of a material of this kind; for a mix, beside those of its
/// parts.
template <class Kind>
inline constexpr std::size_t most_lobes = 1;
template <>
inline constexpr std::size_t most_lobes<NoMaterial> = 0;
template <>
inline constexpr std::size_t most_lobes<MixedMaterial> = 0;
template <>
inline constexpr std::size_t most_lobes<PlasticMaterial> = 2;
template <>
inline constexpr std::size_t most_lobes<GlassMaterial> = 2;
template <>
inline constexpr std::size_t most_lobes<SubsurfaceMaterial> = most_lobes<GlassMaterial>;
template <>
inline constexpr std::size_t most_lobes<KdSubsurfaceMaterial> = most_lobes<GlassMaterial>;
template <>
inline constexpr std::size_t most_lobes<TranslucentMaterial> = 4;
template <>
inline constexpr std::size_t most_lobes<UberMaterial> = 5;
template <>
inline constexpr std::size_t most_lobes<DisneyMaterial> = 5;

}  // namespace etalon
