#pragma once

#include <optional>

#include "core/numerics/vec.h"
#include "core/scene/shapes.h"
#include "core/scene/shutter.h"

namespace etalon {

/// Number of a primitive, of the scene or of an instance. Of equally near hits the lowest key wins.
using HitKey = std::uint64_t;

inline HitKey key_of(std::uint32_t primitive, std::uint32_t instance) {
    return static_cast<HitKey>(instance + 1) << 32 | primitive;  // no_index + 1 is 0
}

/// Returns the key by which a ray excludes a primitive, of the scene or of an instance; no_index
/// for instances of so high a number that a double, in columns of rays, could not hold it.
inline HitKey exclusion_of(std::uint32_t primitive, std::uint32_t instance) {
    const HitKey key = key_of(primitive, instance);
    return key < HitKey{1} << 53 ? key : no_index;
}

/// The points origin + t * direction with tmin < t <= tmax and t >= 0. The direction need not be a
/// unit vector: t is in units of its length.
struct Ray {
    Vec3 origin, direction;
    double tmin = 0;
    double tmax = infinity;
    /// exclusion_of() a primitive that the ray has just left and cannot hit again, and which need
    /// not be tested; no_index if there is none.
    HitKey exclude = no_index;
    /// Bits of coherent(), is_shadow() and time(), in one word that is copied by one instruction.
    std::uint32_t traits_and_time = 0;

    /// Returns the excluded primitive of an instance, or of the scene; no_index if it is of
    /// another.
    std::uint32_t excluded(std::uint32_t instance = no_index) const {
        return exclude >> 32 == instance + 1 ? static_cast<std::uint32_t>(exclude) : no_index;
    }

    /// Returns a hint, which changes no hit: whether the rays that the same thread traced just
    /// before took nearly the same path through the scene.
    bool coherent() const { return (traits_and_time & coherent_trait) != 0; }
    void set_coherent() { traits_and_time |= coherent_trait; }

    /// Returns whether it is a shadow ray, which passes holes that other rays do not (PBRT's
    /// shadowalpha).
    bool is_shadow() const { return (traits_and_time & shadow_trait) != 0; }
    void set_shadow() { traits_and_time |= shadow_trait; }

    /// Returns the time at which the ray sees the scene.
    ShutterTime time() const { return traits_and_time >> time_shift; }
    void set_time(ShutterTime time) {
        traits_and_time = time << time_shift | (traits_and_time & ((1U << time_shift) - 1));
    }

    static constexpr std::uint32_t coherent_trait = 1, shadow_trait = 2;
    static constexpr int time_shift = 32 - shutter_time_bits;
};

static_assert(sizeof(Ray) == 80);

/// Returns whether a ray can hit anything at all.
inline bool is_valid(const Ray& ray) {
    return is_finite(ray.origin) && is_finite(ray.direction) && max_abs(ray.direction) > 0 &&
           ray.tmin < ray.tmax;
}

struct Hit {
    double t;
    std::uint32_t
        primitive;  ///< number among the primitives of the geometry, or of the instance's object
    std::uint32_t instance = no_index;  ///< number among the geometry's; no_index if none was hit
};

/// A ray with what every triangle and polygon test needs, computed once: the axes permuted so that
/// z is the direction's dominant one (Woop, Benthin & Wald 2013, JCGT 2(1)).
struct RayQuery {
    explicit RayQuery(const Ray& r) : RayQuery(r, dominant_axis(r.direction)) {}

    /// `dominant` is the dominant axis of the direction, where that is known already.
    RayQuery(const Ray& r, int dominant) : ray(r), kz(dominant) {
        kx = (kz + 1) % 3;
        ky = (kz + 2) % 3;
        dx = flush_negligible(kx);
        dy = flush_negligible(ky);
        dz = r.direction[kz];
        ray.tmin = std::max(r.tmin, 0.0);
    }

    Ray ray;
    int kz, kx, ky;
    double dx, dy, dz;

  private:
    /// Returns a component, or 0 if it is below 2^-500 of the largest. That moves no point by even
    /// one rounding, and keeps products in the range in which signs are exact.
    double flush_negligible(int k) {
        double& component = ray.direction[k];
        if (std::abs(component) < 0x1p-500 * std::abs(ray.direction[kz])) component = 0;
        return component;
    }
};

/// Bound on the relative error of the t that any kernel returns. Surfaces that are closer together
/// than this may be hit in the wrong order.
inline constexpr double t_tolerance = 0x1p-36;

/// Value that a kernel returns when the ray misses: a NaN, so that `<` and `<=` are false.
inline constexpr double no_hit = nan_value;

/// The nearest hit so far, and the one rule by which all backends keep it: the smaller t wins, and
/// at equal t the lower number among the geometry's items.
struct NearestHit {
    explicit NearestHit(double tmax) : t(tmax) {}

    bool is_beaten_by(double candidate, std::uint32_t id) const {
        return candidate < t || (candidate == t && id < item && t < infinity);
    }

    void offer(double candidate, std::uint32_t id) {
        if (is_beaten_by(candidate, id)) {
            t = candidate;
            item = id;
        }
    }

    /// Offers an instance with the hit on a primitive of its object.
    void offer(double candidate, std::uint32_t id, std::uint32_t primitive) {
        if (!is_beaten_by(candidate, id)) return;
        offer(candidate, id);
        part = primitive;
    }

    bool found() const { return item != no_index; }

    double t;
    std::uint32_t item = no_index;
    std::uint32_t part = no_index;  ///< primitive of the object, if the item is an instance
};

}  // namespace etalon
