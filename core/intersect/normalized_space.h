// The normalized space in which accelerators work: the bounded part of the scene moved to the
// origin and scaled by a power of two into [-1, 1]^3, so that float boxes are as good far from the
// origin, and for scenes of any size, as they are for the unit box.
#pragma once

#include <optional>

#include "core/intersect/ray.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// A float ray in normalized space. `scale` turns a double t of the world into a float t of
/// normalized space: t_normalized = (t - shift) * scale.
struct NormalizedRay {
    Vec3f origin, direction;  ///< |origin| <= 3, the direction's largest component in [1, 2)
    double shift, scale;

    /// Returns tmin in normalized space, rounded down but not below 0: nothing lies before that.
    /// The branch is well predicted, as most rays start there, and it skips the roundings.
    float tmin(double t) const { return t <= shift ? 0 : float_down((t - shift) * scale); }

    /// Returns tmax in normalized space, rounded up, so that a hit at exactly t is never culled.
    /// Always finite: the largest float for an infinite t.
    float tmax(double t) const {
        constexpr float last = std::numeric_limits<float>::max();
        return t == infinity ? last : std::min(float_up((t - shift) * scale), last);
    }
};

/// Padding of the boxes of instances around their content.
struct InstancePadding {
    double box;        ///< in normalized space
    double roundings;  ///< as a fraction of the scene's half size: see instance_bounds()
};

class NormalizedSpace {
  public:
    static constexpr double largest_origin = 3;
    static constexpr double largest_distance = 0x1p24;  ///< largest |origin|, for resolves()
    static constexpr double largest_speed = 0x1p900;    ///< its reciprocal is the smallest

    /// Distance from the box of all that is bounded at which a line is taken to miss it. It is
    /// thirty times `padding`, generous on purpose.
    static constexpr double margin = 0x1p-14;

    NormalizedSpace() = default;

    /// Hits of resolved rays may lie outside of `world` by `drift` times half its size.
    explicit NormalizedSpace(const Box3& world, double drift = 0);

    /// Padding that a box needs around its content so that a float slab test, with a reciprocal
    /// good to 2.6 units of rounding, cannot miss what a double ray hits: u (7 |o| + 5 |b|) for u =
    /// 2^-24, |o| <= 3, the largest origin of a NormalizedRay, and |b| <= 1.
    static constexpr double padding = unit_roundoff_f * (7 * largest_origin + 5);

    /// Returns `world` in normalized space, rounded outward and padded.
    Box3f box(const Box3& world, double pad = padding) const;

    /// Maps a point without padding, for geometry that an accelerator intersects by itself.
    Vec3 point(const Vec3& world) const { return (world - centre_) * scale_; }
    double scale() const { return scale_; }
    const Vec3& centre() const { return centre_; }

    /// Returns half the size of the box of all that is bounded, widened by `margin` (of normalized
    /// space) and the drift, in world units. Infinite where nothing is bounded.
    const Vec3& reach() const { return reach_; }

    /// Maps a ray. A ray that starts far away is first advanced, in double, to the neighbourhood of
    /// the scene. Returns nothing if the ray's line misses the scene.
    std::optional<NormalizedRay> ray(const Ray& ray) const;

    /// Returns whether double precision suffices to map the ray. False for rays from so far (2^24
    /// times the scene's size) that a rounding of their double coordinates is no longer small
    /// against the padding. False also for rays that cross the scene in so small or so large a
    /// range of t (2^+-900) that t would leave the range of double in normalized space, and for all
    /// rays where there is no space. Such rays must be tested against everything, unless they
    /// surely miss.
    bool resolves(const Ray& ray) const;

    /// Returns whether the ray's line misses the bounded part of the scene, beyond all roundings of
    /// its coordinates and from any distance.
    bool surely_misses(const Ray& ray) const;

  private:
    Vec3 centre_{0};
    double scale_ = 0;  ///< 0 where nothing is bounded
    Vec3 reach_{infinity};
};

/// Padding for all rays that a space resolves and for float slab tests.
inline constexpr InstancePadding full_padding = {NormalizedSpace::padding, 0x1p-24};

/// Padding for rays that start next to the scene and for slab tests that do not round. The caller
/// must handle all other rays itself.
inline constexpr InstancePadding least_padding = {0, 0x1p-40};

}  // namespace etalon
