// Rays on their way into objects, with the three axes in the lanes of vectors of doubles. Compiled
// for each instruction set; for those with shorter vectors there is nothing here.
#if defined(ETALON_OBJECT_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_OBJECT_RAY_INL_H
#undef ETALON_OBJECT_RAY_INL_H
#else
#define ETALON_OBJECT_RAY_INL_H
#endif

#include <hwy/highway.h>

#include "core/intersect/normalized_ray.h"
#include "core/intersect/object_space.h"
#include "core/intersect/rescaled_ray.h"
#include "core/scene/instance.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 32

namespace hn = hwy::HWY_NAMESPACE;

/// x, y and z in lanes; what the fourth one holds means nothing.
using AxesTag = hn::FixedTag<double, 4>;
using AxesLanes = hn::Vec<AxesTag>;

HWY_INLINE AxesLanes axes(double x) {
    return hn::Set(AxesTag(), x);
}
HWY_INLINE AxesLanes axes(const ObjectSpace::Axes& v) {
    return hn::Load(AxesTag(), v.data());
}

/// Returns the bits, lowest first, of the axes for which a mask is set.
HWY_INLINE std::uint32_t axes_where(hn::Mask<AxesTag> mask) {
    std::uint8_t byte = 0;
    hn::StoreMaskBits(AxesTag(), mask, &byte);
    return byte & 7U;
}

/// Returns y, z and x.
HWY_INLINE AxesLanes next_axis(AxesLanes v) {
    alignas(32) constexpr std::int64_t order[4] = {1, 2, 0, 3};
    return hn::TableLookupLanes(v, hn::SetTableIndices(AxesTag(), order));
}

/// A ray in world space, with each of its components broadcast to all lanes.
struct WorldRayLanes {
    HWY_INLINE explicit WorldRayLanes(const Ray& ray)
        : origin{axes(ray.origin.x), axes(ray.origin.y), axes(ray.origin.z)},
          direction{axes(ray.direction.x), axes(ray.direction.y), axes(ray.direction.z)} {}

    AxesLanes origin[3], direction[3];
};

enum class ObjectEntry {
    misses,     ///< the ray misses the object
    enters,     ///< the ray may hit it
    slow_path,  ///< Intersector::offer_instance decides
};

/// A ray in object space, with the bits of to_object() (placement.h), and the results of
/// misses_bounds() and normalized_ray() for it.
class ObjectRay {
  public:
    HWY_INLINE ObjectRay(const Instance& instance, const WorldRayLanes& ray) {
        static_assert(offsetof(Instance, origin) == 9 * sizeof(double));
        AxesLanes x, y, z;  // columns: what is loaded behind the rows is the origin
        hn::LoadInterleaved3(AxesTag(), &instance.rows[0].x, x, y, z);
        const Vec3& c = instance.origin;
        origin_ = x * (ray.origin[0] - axes(c.x)) + y * (ray.origin[1] - axes(c.y)) +
                  z * (ray.origin[2] - axes(c.z));
        direction_ = x * ray.direction[0] + y * ray.direction[1] + z * ray.direction[2];
    }

    /// Returns how the ray meets an object with the given space. Sets `to` if the ray enters it.
    HWY_INLINE ObjectEntry entry(const ObjectSpace& space, NormalizedRay& to) const {
        if (misses_bounds(space)) return ObjectEntry::misses;
        if (HWY_UNLIKELY(!is_usual(space))) return ObjectEntry::slow_path;
        return normalize(space, to) ? ObjectEntry::enters : ObjectEntry::misses;
    }

    /// Returns the ray up to `tmax`, in the instance of that number. Everything else is as for
    /// to_object() of `world`.
    HWY_INLINE Ray ray(const Ray& world, double tmax, std::uint32_t instance) const {
        alignas(32) ObjectSpace::Axes o, d;
        hn::Store(origin_, AxesTag(), o.data());
        hn::Store(direction_, AxesTag(), d.data());
        return {{o[0], o[1], o[2]},       {d[0], d[1], d[2]},   world.tmin, tmax,
                world.excluded(instance), world.traits_and_time};
    }

  private:
    HWY_INLINE bool misses_bounds(const ObjectSpace& space) const {
        const AxesLanes o = origin_ - axes(space.centre), &d = direction_;
        const auto away = hn::And(hn::Abs(o) > axes(space.outside), o * d > axes(0.0));
        const AxesLanes next_o = next_axis(o), next_d = next_axis(d);
        const AxesLanes a = o * next_d, b = next_o * d;
        const AxesLanes within =
            axes(space.reach) * hn::Abs(next_d) + axes(space.next_reach) * hn::Abs(d);
        const AxesLanes roundings = axes(0x1p-40) * (hn::Abs(a) + hn::Abs(b)) + axes(0x1p-1000);
        return axes_where(hn::Or(away, hn::Abs(a - b) > within + roundings)) != 0;
    }

    /// Returns whether the numbers are of usual size, as nearly all are, so that is_resolved()
    /// holds.
    HWY_INLINE bool is_usual(const ObjectSpace& space) const {
        const AxesLanes distance = hn::Abs(origin_ - axes(space.centre)),
                        size = hn::Abs(direction_);
        const auto none_extreme =
            hn::And(distance < axes(space.furthest), size <= axes(largest_usual_direction));
        return axes_where(none_extreme) == 7 &&
               axes_where(size >= axes(1 / largest_usual_direction)) != 0 && space.is_usual();
    }

    /// Normalizes a ray that is_usual(). Returns false if its line misses the object.
    HWY_INLINE bool normalize(const ObjectSpace& space, NormalizedRay& to) const {
        const hn::RebindToUnsigned<AxesTag> words;
        const AxesLanes size = hn::Abs(direction_), two = hn::Max(size, next_axis(size)),
                        largest = hn::Max(two, next_axis(two));
        const auto field = hn::ShiftRight<52>(hn::BitCast(words, largest));
        const auto mirrored = hn::Sub(hn::Set(words, 2 * 1023), field);
        const AxesLanes shrink = hn::BitCast(AxesTag(), hn::ShiftLeft<52>(mirrored));
        const AxesLanes grow = hn::BitCast(AxesTag(), hn::ShiftLeft<52>(field));

        const AxesLanes direction = direction_ * shrink;
        AxesLanes origin = (origin_ - axes(space.centre)) * axes(space.scale);
        const AxesLanes largest_origin = axes(NormalizedSpace::largest_origin);
        to.scale = space.scale * hn::GetLane(grow);
        to.shift = 0;
        if (axes_where(hn::Abs(origin) > largest_origin) != 0) {
            const double length2 = sum(direction * direction);
            const double shift =
                -sum(origin * direction) / length2 - 2 * about_inverse_root(length2);
            origin = origin + axes(shift) * direction;
            if (axes_where(hn::Abs(origin) > largest_origin) != 0) return false;
            to.shift = shift / to.scale;
        }
        store(origin, to.origin);
        store(direction, to.direction);
        return true;
    }

    /// To a thousandth: where a ray starts, 2 before the closest approach, leaves much more room.
    static HWY_INLINE double about_inverse_root(double x) {
        const hn::FixedTag<float, 4> tag;
        return hn::GetLane(hn::ApproximateReciprocalSqrt(hn::Set(tag, static_cast<float>(x))));
    }

    static HWY_INLINE double sum(AxesLanes v) {
        const AxesLanes y = next_axis(v);
        return hn::GetLane(v + y + next_axis(y));
    }

    static HWY_INLINE void store(AxesLanes v, Vec3f& to) {
        alignas(16) std::array<float, 4> lanes;
        const hn::Rebind<float, AxesTag> floats;
        hn::Store(hn::DemoteTo(floats, v), floats, lanes.data());
        to = {lanes[0], lanes[1], lanes[2]};
    }

    AxesLanes origin_, direction_;
};

#endif

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
