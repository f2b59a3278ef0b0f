#include "core/intersect/parametrization.h"

#include "core/intersect/placement.h"
#include "core/intersect/shapes/all_shapes.h"

namespace etalon {
namespace {

/// Returns whether the derivatives span a plane: false where they are parallel, zero or not finite.
bool spans_plane(Vec3 dpdu, Vec3 dpdv) {
    dpdu *= power_of_two_reciprocal(max_abs(dpdu));  // else the product may overflow or underflow
    dpdv *= power_of_two_reciprocal(max_abs(dpdv));
    const Vec3 normal = dpdu.cross(dpdv);
    return is_finite(normal) && normal != Vec3(0);
}

}  // namespace

Parametrization parametrization_at(const Geometry& geometry, const SurfacePoint& point) {
    if (point.instance != no_index) {
        const InstanceAt instance(geometry, point.instance, point.time);
        return placed(*instance, parametrization_at(geometry.objects[instance->object],
                                                    local_point(*instance, point)));
    }
    const Primitive p = geometry.primitives[point.primitive];
    Parametrization at = with_shape(p.kind, [&]<class Shape>() {
        return parametrization(geometry, geometry.get<Shape>(p), point);
    });
    if (!spans_plane(at.dpdu, at.dpdv)) orthonormal_basis(point.normal, at.dpdu, at.dpdv);
    return at;
}

}  // namespace etalon
