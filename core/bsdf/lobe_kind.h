// Interface of the lobes of a BSDF. Directions are local, with the shading normal as z.
//
// All lobes: `kind`; `albedo(wo)`, an estimate of the fraction of light from `wo` that it scatters,
// never 0 where it scatters any; `scale(by)`, which multiplies it. Smooth lobes: `evaluate(wo,
// wi)`, which is defined for any two directions, though only the lobes of the side on which `wi`
// lies by the geometric normal are evaluated; `sample(wo, uv)`, a direction with the density that
// `evaluate` returns, or none. Samples of a lobe of one side that lie on the other by the geometric
// normal are turned to the opposite direction, between the horizons of both normals, where the lobe
// may have a value too. Specular lobes: `sample(wo, choice)`.
#pragma once

#include <cstdint>
#include <optional>

namespace etalon {

/// The side to which a smooth lobe scatters, or both. Specular lobes decide the side themselves.
enum class LobeKind : std::uint8_t { reflection, transmission, both, specular };

/// Returns whether smooth lobes of this kind scatter light to a side.
constexpr bool scatters_to(LobeKind side, LobeKind kind) {
    return kind == side || kind == LobeKind::both;
}

}  // namespace etalon
