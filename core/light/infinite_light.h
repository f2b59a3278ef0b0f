#pragma once

#include <cstdint>
#include <string>

#include "core/light/light_sample.h"
#include "core/light/piecewise_constant.h"
#include "core/light/skybox_light.h"
#include "core/light/spherical_image.h"
#include "core/scene/physical_light.h"

namespace etalon {

/// Distribution by which directions to an image of all directions are sampled.
enum class SkySampling : std::uint8_t {
    /// In proportion to how much brighter than its mean it is (MIS compensation: Karlik et al.
    /// 2019). Darker parts are left to the directions that surfaces sample.
    above_mean,
    /// In proportion to its brightness, in cells that may have many texels. If media may end the
    /// rays of sampled directions, sampled and attenuated light is less noisy.
    whole,
};

/// Light from all directions: from an image by latitude and longitude, a skybox or of one colour. A
/// light of one colour is left to the directions that surfaces and media sample.
class InfiniteLight {
  public:
    /// `problems` gets the reason if the image cannot be read; the light has no image then. A
    /// source with a skybox must outlive the light.
    InfiniteLight(const InfiniteSource& source, std::vector<std::string>& problems,
                  SkySampling sampling = SkySampling::above_mean);

    Color radiance(const Vec3& direction) const;

    /// Samples a direction to the light; of density 0 if the light is left to surfaces.
    LightSample sample(const Vec2& uv) const;

    /// Returns the density of sample() per steradian.
    double pdf(const Vec3& direction) const;

    /// Returns the mean over all directions.
    const Color& mean() const { return mean_; }

    /// Returns whether sample() can return any direction.
    bool can_be_sampled() const { return !places_.empty(); }

  private:
    Color lookup(const Vec2& place) const;
    Vec2 place_of(const Vec3& direction) const;
    void prepare_sampling(SkySampling sampling);
    double stretch(const Vec3& direction) const;

    InfiniteSource source_;
    Affine to_world_;
    bool keeps_angles_;  ///< the map to the image does
    std::unique_ptr<const SkyboxLight> skybox_;
    SphericalImage image_;  ///< for a skybox, an overview from which directions are sampled
    Color mean_{0.0F};
    PiecewiseConstant2D places_;  ///< distribution of directions
};

}  // namespace etalon
