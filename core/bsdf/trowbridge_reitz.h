#pragma once

#include "core/bsdf/local_direction.h"

namespace etalon {

/// Microfacet distribution of Trowbridge and Reitz 1975, known as GGX, with Smith's
/// height-correlated masking (Heitz 2014, "Understanding the Masking-Shadowing Function").
/// Directions are local; only the magnitude of a direction's z matters.
class TrowbridgeReitz {
  public:
    /// Roughness along x and y; values below 0.001 are raised to it.
    TrowbridgeReitz(float alpha_x, float alpha_y)
        : alpha_x_(std::max(0.001F, alpha_x)), alpha_y_(std::max(0.001F, alpha_y)) {}

    /// Returns whether the roughness is the same along x and y.
    bool is_isotropic() const { return alpha_x_ == alpha_y_; }

    float mean_alpha() const { return (alpha_x_ + alpha_y_) / 2; }

    /// Returns the density of microfacets with the unit normal `m`, per solid angle and their area.
    float density(const Vec3f& m) const {
        const float x = m.x / alpha_x_, y = m.y / alpha_y_;
        const float slant = x * x + y * y + m.z * m.z;
        return inverse_pi / (alpha_x_ * alpha_y_ * slant * slant);
    }

    /// Returns the quantity for which the unmasked projected area of the facets along `w`, over
    /// that of the surface, is (|w.z| + stretched(w)) / 2.
    float stretched(const Vec3f& w) const {
        const float x = alpha_x_ * w.x, y = alpha_y_ * w.y;
        return std::sqrt(x * x + y * y + w.z * w.z);
    }

    /// Returns the fraction of the facets visible from both directions over 4 |wo.z| |wi.z|.
    float visibility(const Vec3f& wo, const Vec3f& wi) const {
        return 0.5F / (stretched(wo) * std::abs(wi.z) + stretched(wi) * std::abs(wo.z));
    }

    /// Returns the factor of density(m) |w.m| that gives the density, per solid angle, of the
    /// normals m of facets visible from `w`.
    float visible_scale(const Vec3f& w) const { return 2 / (std::abs(w.z) + stretched(w)); }

    /// Samples a normal on the side of `w` of a facet visible from there, with that density.
    Vec3f sample_visible(const Vec3f& w, const Vec2& uv) const { return sample(w, uv, 1); }

    /// Samples the direction to which a visible facet mirrors `w`; the second function returns its
    /// density per solid angle from density(m) of the facet's normal. Most directions below the
    /// surface are excluded.
    Vec3f sample_reflected(const Vec3f& w, const Vec2& uv) const;
    float reflected_density(const Vec3f& w, float density) const {
        return density / (2 * (bound(w) * std::abs(w.z) + stretched(w)));
    }

  private:
    /// Returns the height of the cap's rim below the stretched sphere's equator over that of its
    /// pole's mirror image: 1 for all visible facets, less without those that mirror to below the
    /// surface.
    float bound(const Vec3f& w) const;
    Vec3f sample(const Vec3f& w, const Vec2& uv, float bound) const;

    float alpha_x_, alpha_y_;
};

/// Returns Trowbridge and Reitz's alpha for a perceptually even roughness from 0 to 1, by the
/// polynomial of PBRT version 3.
float alpha_of_roughness(float roughness);

}  // namespace etalon
