#include "core/intersect/oracle/definitions.h"

#include "core/intersect/oracle/define.h"

namespace etalon {

Crossings crossings(const Scene& scene, std::uint32_t primitive, const Ray& ray) {
    const Primitive& p = scene.primitives[primitive];
    const Ray meant = RayQuery(ray).ray;
    return with_shape(p.kind, [&]<class Shape>() {
        return definition::define(scene, scene.get<Shape>(p), meant);
    });
}

}  // namespace etalon
