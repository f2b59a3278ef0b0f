// What every lobe of a BSDF offers. Directions are local, with the shading normal as z.
//
// All: `kind`; `albedo(wo)`, an estimate of the part of light from `wo` that it scatters, never 0
// where it scatters any; `scale(by)`, which multiplies it.
// A smooth lobe: `evaluate(wo, wi)`, whose value answers for any two directions, though only the
// lobes of the side that `wi` lies on by the geometric normal are asked; `sample(wo, uv)`, a
// direction with the density that `evaluate` says, or none.
// A diffuse lobe is a smooth one with `is_diffuse`. Its value is about the same for all directions
// on its side of the geometric normal, so its density, too, answers for any two directions: samples
// on the wrong side of that normal are to be turned round.
// A specular lobe: `sample(wo, choice)`.
#pragma once

#include <cstdint>
#include <optional>

namespace etalon {

/// The side to which a smooth lobe scatters, that it scatters to both, or that a lobe is specular,
/// which knows its side.
enum class LobeKind : std::uint8_t { reflection, transmission, both, specular };

/// Returns whether smooth lobes of this kind scatter light to a side.
constexpr bool scatters_to(LobeKind side, LobeKind kind) {
    return kind == side || kind == LobeKind::both;
}

}  // namespace etalon
