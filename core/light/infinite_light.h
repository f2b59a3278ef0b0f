#pragma once

#include <cstdint>
#include <string>

#include "core/light/light_sample.h"
#include "core/light/piecewise_constant.h"
#include "core/light/skybox_light.h"
#include "core/light/spherical_image.h"
#include "core/scene/physical_light.h"

namespace etalon {

/// By what directions to an image of all directions are chosen.
enum class SkySampling : std::uint8_t {
    /// By how much it is brighter than its mean (MIS compensation: Karlik et al. 2019); what is
    /// darker is left to the directions that surfaces choose.
    above_mean,
    /// By its brightness, in cells that may have many texels. Where media may end the rays of
    /// chosen
    /// directions, light that is asked for, and weakened, is less noisy.
    whole,
};

/// Light from all around, from an image by latitude and longitude, a skybox or of one colour.
/// A light of one colour is left to the directions that surfaces and media choose.
class InfiniteLight {
  public:
    /// `problems` gets the reason where the image cannot be read; the light has no image then. A
    /// source with a skybox must outlive the light.
    InfiniteLight(const InfiniteSource& source, std::vector<std::string>& problems,
                  SkySampling sampling = SkySampling::above_mean);

    Color radiance(const Vec3& direction) const;

    /// A direction to the light, of density 0 where it is left to surfaces.
    LightSample sample(const Vec2& uv) const;

    /// Density of sample() per steradian.
    double pdf(const Vec3& direction) const;

    /// Mean over all directions.
    const Color& mean() const { return mean_; }

    /// Returns whether sample() has any direction to offer.
    bool can_be_sampled() const { return !places_.empty(); }

  private:
    Color lookup(const Vec2& place) const;
    Vec2 place_of(const Vec3& direction) const;
    void prepare_sampling(SkySampling sampling);

    InfiniteSource source_;
    Affine to_world_;
    std::unique_ptr<const SkyboxLight> skybox_;
    SphericalImage image_;  ///< of a skybox an overview, by which directions are sampled
    Color mean_{0.0F};
    PiecewiseConstant2D places_;  ///< of directions
};

}  // namespace etalon
