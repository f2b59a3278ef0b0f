#include "core/shading/physical_surface.h"

#include "core/intersect/kernels.h"

namespace etalon {

PhysicalSurface physical_surface(const Scene& scene, const Ray& ray, const Hit& hit) {
    PhysicalSurface at{surface_at(scene.geometry, ray, hit), nullptr, Vec3(0), Vec3(0)};
    const SurfacePoint& p = at.point;
    at.binding = &scene.physical().bindings[p.material];
    at.ng = at.binding->flipped ? -p.normal : p.normal;
    at.ns = at.binding->flipped ? -p.shading_normal : p.shading_normal;
    if (at.binding->corner_normals && at.ng.dot(at.ns) < 0) at.ng = -at.ng;
    return at;
}

bool has_null_material(const Scene& scene, const PhysicalSurface& at) {
    const PhysicalLook& look = scene.physical();
    return std::holds_alternative<NoMaterial>(look.materials[at.binding->material].kind);
}

namespace {

/// Sets the tangents of a triangle whose coordinates are degenerate to those of pbrt-v3, which the
/// reflections of anisotropic materials show.
void set_tangents(const Vec3& edge1, const Vec3& edge2, Parametrization& at) {
    const auto scaled = [](const Vec3& v) { return v * power_of_two_reciprocal(max_abs(v)); };
    const Vec3 n = normalized(scaled(edge2).cross(scaled(edge1)));
    at.dpdu = normalized(std::abs(n.x) > std::abs(n.y) ? Vec3(-n.z, 0, n.x) : Vec3(0, n.z, -n.y));
    at.dpdv = n.cross(at.dpdu);
}

/// Replaces the coordinates (0, 0), (1, 0), (1, 1) of a triangle's corners by those of the mesh.
Parametrization with_coordinates(const std::array<std::array<float, 2>, 3>& corners,
                                 const Parametrization& own) {
    const auto at = [&](std::size_t k) { return Vec2(corners[k][0], corners[k][1]); };
    const double second = own.uv.y, first = own.uv.x - own.uv.y;
    // With p = p0 + first (p1 - p0) + second (p2 - p0): dpdu is p1 - p0, dpdv is p2 - p1.
    const Vec2 to1 = at(1) - at(0), to2 = at(2) - at(0);
    const Vec3 edge1 = own.dpdu, edge2 = own.dpdu + own.dpdv;
    Parametrization result{at(0) + first * to1 + second * to2, own.dpdu, own.dpdv};
    const double determinant = to1.x * to2.y - to1.y * to2.x;
    if (!(std::abs(determinant) >= 1e-8)) {  // pbrt-v3's limit
        set_tangents(edge1, edge2, result);
        return result;
    }
    result.dpdu = (to2.y * edge1 - to1.y * edge2) / determinant;
    result.dpdv = (to1.x * edge2 - to2.x * edge1) / determinant;
    return result;
}

}  // namespace

Parametrization with_coordinates_of_mesh(const Geometry& geometry, std::uint32_t primitive,
                                         std::uint32_t uv_offset, const Parametrization& own) {
    if (uv_offset == no_index) return own;
    const Primitive p = geometry.primitives[primitive];
    const TriangleIndices vertices = geometry.get<Triangle>(p).vertices;
    std::array<std::array<float, 2>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = geometry.uvs[vertices[k] - uv_offset];
    return with_coordinates(corners, own);
}

Parametrization physical_parametrization(const Scene& scene, const PhysicalSurface& at) {
    return with_coordinates_of_mesh(scene.geometry.holder(at.point.instance), at.point.primitive,
                                    at.binding->uv_offset,
                                    parametrization_at(scene.geometry, at.point));
}

}  // namespace etalon
