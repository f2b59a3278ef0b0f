#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/local_direction.h"

namespace etalon {

/// Parameters of a hair at a point.
struct HairFibre {
    float h;             ///< position across the width, from -1 to 1
    float eta;           ///< index inside over that outside
    Color absorption;    ///< per radius
    float along_width;   ///< roughness beta_m, 0 to 1
    float across_width;  ///< roughness beta_n, 0 to 1
    float tilt;          ///< alpha of the scales, in degrees
};

/// Scattering of a hair, as a cylinder that is hit at one position across its width: Chiang,
/// Bitterli, Tappan and Burley 2016, "A Practical and Controllable Hair and Fur Model for
/// Production Path Tracing". x is along the hair. One formula covers both sides.
///
/// Bessel's function is summed until it is exact, so that a hair without absorption scatters all
/// light. pbrt-v3 sums ten terms, which is up to 2.5 % too little for arguments about 12.
class HairScattering {
  public:
    static constexpr LobeKind kind = LobeKind::both;

    explicit HairScattering(const HairFibre& fibre);

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const;
    Color albedo(const Vec3f& wo) const;
    void scale(const Color& by) { factor_ *= by; }

  private:
    float h_, index_;
    Color absorption_;
    float variance_;  ///< longitudinal, of reflected light
    float spread_;    ///< azimuthal: scale of the logistic distribution
    float sine_of_tilt_;
    Color factor_{1};  ///< factor of the whole lobe
};

/// Returns the absorption for concentrations of the two pigments of hair.
Color hair_absorption(float eumelanin, float pheomelanin);

/// Returns the absorption for which dense hair has this colour, with roughness beta_n.
Color hair_absorption_of(const Color& reflectance, float across_width);

}  // namespace etalon
