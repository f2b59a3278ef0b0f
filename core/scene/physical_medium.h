// Physical participating media. Plain data; core/medium follows rays through them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/numerics/affine.h"
#include "core/scene/shapes.h"

namespace etalon {

/// Densities at the centres of the cells of a box, interpolated linearly between them, 0 outside
/// the box. They scale the coefficients of a medium.
struct DensityGrid {
    std::array<int, 3> size;       ///< cells along x, y and z
    std::vector<float> densities;  ///< not below 0; x varies fastest, then y
    Affine to_box;                 ///< maps the world to the cube [0, 1]^3, which is the box
};

/// A participating medium. Coefficients are not below 0, per unit of length of the world.
struct PhysicalMedium {
    Color absorption, scattering;
    float g = 0;  ///< mean cosine of scattering, between -1 and 1
    std::optional<DensityGrid> grid{};

    Color extinction() const { return absorption + scattering; }
};

/// The media on the two sides of a surface, as numbers among the look's. A surface with the same
/// medium on both sides leaves a ray in the medium from which it comes.
struct MediumInterface {
    std::uint32_t inside = no_index;   ///< behind the side that the format calls the front
    std::uint32_t outside = no_index;  ///< no_index for a vacuum

    bool is_transition() const { return inside != outside; }
    bool operator==(const MediumInterface&) const = default;
};

}  // namespace etalon
