// Images of shapes under affine maps, as in other renderers: the ray is transformed to the shape's
// own coordinates by an inverse that is rounded, too (Pharr, Jakob & Humphreys 2016, section
// 3.1.4).
#pragma once

#include <algorithm>

#include "bench/accuracy/textbook/sphere.h"

namespace etalon::accuracy {

/// A ray in shape coordinates. Its direction is not normalized: t is that of world space.
template <class RayForm>
class RayMover {
  public:
    RayMover(const Vec3& origin, const LocalFrame& frame)
        : origin_(origin), x_(frame.row(0)), y_(frame.row(1)), z_(frame.row(2)) {}

    RayForm operator()(RayForm ray) const {
        ray.origin = moved(ray.origin - origin_);
        ray.direction = moved(ray.direction);
        return ray;
    }

  private:
    using V = decltype(RayForm::origin);

    V moved(const V& v) const { return {x_.dot(v), y_.dot(v), z_.dot(v)}; }

    V origin_, x_, y_, z_;
};

/// The kernel of a unit sphere about the origin, called for a transformed ray.
template <class SphereKernel>
struct MovedSphere {
    using RayForm = typename SphereKernel::RayForm;

    explicit MovedSphere(const Ellipsoid& e) : mover(e.to_world.origin, e.frame) {}

    auto first_hit(const RayForm& ray) const { return unit.first_hit(mover(ray)); }

    RayMover<RayForm> mover;
    SphereKernel unit{Sphere{{0, 0, 0}, 1}};
};

inline auto textbook_kernels(const Scene&, const Ellipsoid& e) {
    return std::tuple{Named{"float textbook", MovedSphere<TextbookSphere<float>>(e)},
                      Named{"float RTG7", MovedSphere<RecentredSphere>(e)},
                      Named{"double textbook", MovedSphere<TextbookSphere<double>>(e)}};
}

/// The line's interval inside the infinite cylinder x^2 + y^2 = 1 and inside the slab 0 <= z <= 1
/// (Kay & Kajiya 1986, SIGGRAPH), by the quadratic formula.
template <class Real>
struct TextbookClosedCylinder {
    using RayForm = PlainRay<Real>;

    explicit TextbookClosedCylinder(const ClosedCylinder& c) : mover(c.to_world.origin, c.frame) {}

    Real first_hit(const RayForm& world) const {
        const RayForm ray = mover(world);
        const Vec<Real>&o = ray.origin, &d = ray.direction;
        const Real a = d.x * d.x + d.y * d.y;
        const Real b = o.x * d.x + o.y * d.y;
        const Real c = o.x * o.x + o.y * o.y - 1;
        const Real discriminant = b * b - a * c;
        if (discriminant < 0 || (a == 0 && c > 0)) return no_root<Real>;
        const Real root = std::sqrt(discriminant), base = -o.z / d.z, top = (1 - o.z) / d.z;
        Real near = (-b - root) / a, far = (-b + root) / a;
        if (a == 0) near = std::min(base, top), far = std::max(base, top);
        if (d.z != 0) {
            near = std::max(near, std::min(base, top));
            far = std::min(far, std::max(base, top));
        } else if (o.z < 0 || o.z > 1) {
            return no_root<Real>;
        }
        return near <= far ? first_within(ray, near, far) : no_root<Real>;
    }

    RayMover<RayForm> mover;
};

inline auto textbook_kernels(const Scene&, const ClosedCylinder& c) {
    return std::tuple{Named{"float textbook", TextbookClosedCylinder<float>(c)},
                      Named{"double textbook", TextbookClosedCylinder<double>(c)}};
}

}  // namespace etalon::accuracy
