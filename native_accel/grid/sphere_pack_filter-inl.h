// Filter for the spheres of a pack that a ray could hit. Compiled for each instruction set.
#if defined(ETALON_GRID_SPHERE_PACK_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_GRID_SPHERE_PACK_FILTER_INL_H
#undef ETALON_GRID_SPHERE_PACK_FILTER_INL_H
#else
#define ETALON_GRID_SPHERE_PACK_FILTER_INL_H
#endif

#include "core/accel/clusters/lanes-inl.h"
#include "native_accel/grid/sphere_pack.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Filters by the squared distance of the centre from the ray's line, in a plane perpendicular to
/// it. Everything that the kernel would hit passes; the kernel decides about what passes.
class SpherePackFilter {
  public:
    HWY_INLINE explicit SpherePackFilter(const NormalizedRay& ray) {
        const Vec3 d(ray.direction), o(ray.origin);
        Vec3 u, v;
        orthonormal_basis(normalized(d), u, v);
        u_ = Axis(u, o);
        v_ = Axis(v, o);
    }

    /// Returns the lanes, lowest first, that the ray's line could hit.
    HWY_INLINE std::uint32_t candidates(const SpherePack& pack) const {
        return lanes_where([&](std::size_t i) HWY_ATTR {
            const Floats p = u_.of(pack.centre, i), q = v_.of(pack.centre, i);
            return hn::Le(hn::MulAdd(p, p, hn::Mul(q, q)), load(pack.limit, i));
        });
    }

  private:
    /// One of two coordinates perpendicular to the ray.
    struct Axis {
        Axis() = default;
        HWY_INLINE Axis(const Vec3& axis, const Vec3& ray_origin) {
            const Vec3f rounded(axis);
            for (int k = 0; k < 3; ++k) direction[k] = broadcast(rounded[k]);
            origin = broadcast(static_cast<float>(Vec3(rounded).dot(ray_origin)));
        }
        HWY_INLINE Floats of(const std::array<Lanes, 3>& p, std::size_t i) const {
            const Floats yz =
                hn::MulAdd(load(p[1], i), direction[1], hn::Mul(load(p[2], i), direction[2]));
            return hn::Sub(hn::MulAdd(load(p[0], i), direction[0], yz), origin);
        }
        std::array<Floats, 3> direction;
        Floats origin;
    };

    Axis u_, v_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
