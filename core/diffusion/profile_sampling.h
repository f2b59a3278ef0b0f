#pragma once

#include <optional>

#include "core/bsdf/bsdf_frame.h"
#include "core/diffusion/subsurface.h"

namespace etalon {

/// A segment on which surfaces are searched at which light enters.
struct Probe {
    Vec3 origin, direction;  ///< the direction has unit length
    double length;
};

/// Samples the points at which light enters that leaves a surface at another point: along lines
/// near that point, parallel to one of three axes (King, Kulla, Conty & Fajardo 2013, "BSSRDF
/// Importance Sampling"). Profile and frame must outlive it.
class ProfileSampling {
  public:
    ProfileSampling(const SpreadProfile& profile, const BsdfFrame& frame, const Vec3& position)
        : profile_(profile), frame_(frame), position_(position) {}

    /// Samples a probe with `choice` and `uv` in [0, 1). Nothing if they select none.
    std::optional<Probe> probe(double choice, const Vec2& uv) const;

    /// Returns the power per area that comes from a point.
    Color value(const Vec3& point) const;

    /// Returns the density per area with which a point of a surface of that normal is on a probe,
    /// over all axes and channels. As in pbrt-v3 it includes channels whose probes end before they
    /// reach the point: where a surface is oblique to all axes, up to 3 % of the light that goes
    /// farthest is lost.
    float density(const Vec3& point, const Vec3& normal) const;

  private:
    const SpreadProfile& profile_;
    const BsdfFrame& frame_;
    Vec3 position_;
};

}  // namespace etalon
