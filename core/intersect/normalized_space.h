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

    /// tmin in normalized space, rounded down but not below 0: before that there is nothing. Most
    /// rays begin there and have no end, which is predicted: nothing waits for the roundings then.
    float tmin(double t) const { return t <= shift ? 0 : float_down((t - shift) * scale); }

    /// tmax in normalized space, rounded up, so what lies at t exactly is never culled; finite.
    float tmax(double t) const {
        constexpr float last = std::numeric_limits<float>::max();
        return t == infinity ? last : std::min(float_up((t - shift) * scale), last);
    }
};

/// By how much boxes of instances are larger than what they hold.
struct InstancePadding {
    double box;        ///< in normalized space
    double roundings;  ///< in parts of the scene's half size: see instance_bounds()
};

class NormalizedSpace {
  public:
    static constexpr double largest_origin = 3;
    static constexpr double largest_distance = 0x1p24;  ///< of an origin, for resolves()
    static constexpr double largest_speed = 0x1p900;    ///< and its reciprocal the smallest

    /// How far outside of the box of all that is bounded a line is taken to pass it by: thirty
    /// times `padding`, for this is no place to save.
    static constexpr double margin = 0x1p-14;

    NormalizedSpace() = default;
    explicit NormalizedSpace(const Box3& world);

    /// Padding that a box needs around its content so that a float slab test with a reciprocal good
    /// to 2.6 units of rounding cannot miss what a double ray hits: u (7 |o| + 5 |b|), u = 2^-24,
    /// |o| <= 3 the largest origin a NormalizedRay can have, |b| <= 1.
    static constexpr double padding = unit_roundoff_f * (7 * largest_origin + 5);

    /// `world` in normalized space, rounded outward and padded.
    Box3f box(const Box3& world, double pad = padding) const;

    /// Maps a point without padding: for geometry that an accelerator decides on by itself.
    Vec3 point(const Vec3& world) const { return (world - centre_) * scale_; }
    double scale() const { return scale_; }
    const Vec3& centre() const { return centre_; }

    /// Half the box of all that is bounded, with `margin` (of normalized space) around it, in the
    /// world's units: it reaches so far from the centre. Infinite where nothing is bounded.
    const Vec3& reach() const { return reach_; }

    /// Maps a ray. One that starts far away is first advanced, in double, to the neighbourhood of
    /// the scene. Returns nothing if the ray's line passes the scene by.
    std::optional<NormalizedRay> ray(const Ray& ray) const;

    /// False for rays from so far (2^24 times the scene's size) that a rounding of their double
    /// coordinates is no longer small against the padding, and for those that pass the scene in so
    /// little or so much of t (2^+-900) that t would leave the range of double on its way into the
    /// normalized space, and for all rays where there is no space. They must be tested against
    /// everything, but for those that surely miss.
    bool resolves(const Ray& ray) const;

    /// Returns whether the ray's line passes the bounded part of the scene by, beyond all roundings
    /// of its coordinates, however far it comes from.
    bool surely_misses(const Ray& ray) const;

  private:
    Vec3 centre_{0};
    double scale_ = 0;  ///< 0 where nothing is bounded
    Vec3 reach_{infinity};
};

/// For all rays that a space resolves, and float slab tests.
inline constexpr InstancePadding full_padding = {NormalizedSpace::padding, 0x1p-24};

/// For rays from next to the scene, and slab tests that do not round: whoever takes boxes with so
/// little knows what else a ray needs.
inline constexpr InstancePadding least_padding = {0, 0x1p-40};

}  // namespace etalon
