#pragma once

#include <array>
#include <vector>

namespace etalon {

/// Distributions of the distance between entry and exit of light in media of one mean cosine and
/// one index, for all albedos, in mean free paths. Tabulated as by pbrt-v3.
class DiffusionTable {
  public:
    static constexpr std::size_t albedos = 100, radii = 64;
    using Row = std::array<float, radii>;

    /// `g`: mean cosine, between -1 and 1; `eta`: index below the surface over that above.
    DiffusionTable(float g, float eta);

    /// Data of one medium: 2 pi r times the power per area at a distance r, and its integral up to
    /// there.
    struct Rows {
        Row values, sums;

        float albedo() const { return sums.back(); }  ///< fraction of light that leaves anywhere
    };
    /// Returns the rows of the medium with this single-scattering albedo, between 0 and 1.
    Rows at(float albedo) const;

    /// Returns the single-scattering albedo of a medium of which this fraction of light leaves.
    float albedo_of(float effective_albedo) const;

    /// Returns the distances of the rows' values.
    static const Row& distances();

  private:
    std::array<float, albedos> albedos_;
    std::array<float, albedos> effective_;
    std::vector<Rows> rows_;
};

}  // namespace etalon
