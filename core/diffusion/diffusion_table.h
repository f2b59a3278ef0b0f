#pragma once

#include <array>
#include <vector>

namespace etalon {

/// How far from where it came in light comes out of media of one mean cosine and one index, for all
/// albedos: the distribution of distances, in mean free paths. As pbrt-v3 tabulates it.
class DiffusionTable {
  public:
    static constexpr std::size_t albedos = 100, radii = 64;
    using Row = std::array<float, radii>;

    /// `g`: mean cosine, between -1 and 1; `eta`: index below the surface over that above.
    DiffusionTable(float g, float eta);

    /// What one medium has: 2 pi r times the power per area at a distance r, and its integral up to
    /// there.
    struct Rows {
        Row values, sums;

        float albedo() const { return sums.back(); }  ///< part that comes out anywhere
    };
    /// Of the medium that scatters this part of what meets it, between 0 and 1.
    Rows at(float albedo) const;

    /// How much of what meets it a medium scatters of which this part comes out.
    float albedo_of(float effective_albedo) const;

    /// The distances of the rows' numbers.
    static const Row& distances();

  private:
    std::array<float, albedos> albedos_;
    std::array<float, albedos> effective_;
    std::vector<Rows> rows_;
};

}  // namespace etalon
