#include "core/oracle/definitions.h"

#include "core/oracle/define.h"

namespace etalon {

Crossings crossings(const Geometry& geometry, std::uint32_t primitive, const Ray& ray) {
    const Primitive p = geometry.primitives[primitive];
    const Ray meant = RayQuery(ray).ray;
    return with_shape(p.kind, [&]<class Shape>() {
        return definition::define(geometry, geometry.get<Shape>(p), meant);
    });
}

}  // namespace etalon
