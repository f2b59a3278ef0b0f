#include "embree_backend/float_geometry.h"

#include <array>

#include "core/numerics/rounding.h"

namespace etalon {
namespace {

struct FloatSphere {
    Vec3f centre;
    float radius;
};

/// Returns the index of a vertex in the common buffer: first the vertices, then the decimal ones,
/// then the corners of polygons.
std::uint32_t buffer_index(const Geometry& geometry, std::uint32_t vertex) {
    if ((vertex & decimal_vertex) == 0) return vertex;
    return static_cast<std::uint32_t>(geometry.vertices.size()) + (vertex & ~decimal_vertex);
}

std::size_t vertex_count(const Geometry& geometry) {
    return geometry.vertices.size() + geometry.decimal_vertices.size() +
           geometry.all<Polygon>().corners().size();
}

/// Returns the index of a polygon's first corner in that buffer.
std::uint32_t buffer_index(const Geometry& geometry, const Polygon& polygon) {
    const std::span<const Vec3> all = geometry.all<Polygon>().corners();
    const std::size_t before = vertex_count(geometry) - all.size();
    return static_cast<std::uint32_t>(before + (polygon.corners.data() - all.data()));
}

EmbreeOwned<RTCBuffer> float_vertices(const EmbreeDevice& device, const Geometry& geometry,
                                      const NormalizedSpace& space) {
    constexpr std::size_t overread = sizeof(float);  // Embree loads the last vertex as a vector
    EmbreeOwned<RTCBuffer> buffer(
        rtcNewBuffer(device.handle(), vertex_count(geometry) * sizeof(Vec3f) + overread));
    device.check();
    auto* to = static_cast<Vec3f*>(rtcGetBufferData(buffer.get()));
    for (const Vec3& v : geometry.vertices) *to++ = Vec3f(space.point(v));
    for (std::uint32_t i = 0; i < geometry.decimal_vertices.size(); ++i) {
        *to++ = Vec3f(space.point(geometry.vertex(i | decimal_vertex)));
    }
    for (const Vec3& v : geometry.all<Polygon>().corners()) *to++ = Vec3f(space.point(v));
    return buffer;
}

/// Returns a new buffer of the geometry, to be filled with `count` items.
template <class Item>
Item* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
    return static_cast<Item*>(
        rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), count));
}

/// Returns whether Embree can represent a polygon as a quad: two triangles that share the diagonal
/// from corner 1 to corner 3. It can if the polygon is convex and, to the precision of its float
/// corners, flat.
bool is_quad(const Polygon& polygon, const NormalizedSpace& space) {
    const std::span<const Vec3> p = polygon.corners;
    if (p.size() != 4) return false;
    const Vec3 normal = (p[2] - p[0]).cross(p[3] - p[1]);
    const double height = unit_roundoff_f / space.scale() * std::sqrt(normal.dot(normal));
    for (int i = 0; i < 4; ++i) {
        const Vec3 edge = p[(i + 1) % 4] - p[i], next = p[(i + 2) % 4] - p[(i + 1) % 4];
        const bool convex = normal.dot(edge.cross(next)) > 0;
        if (!convex || std::abs(normal.dot(edge)) > height) return false;
    }
    return true;
}

}  // namespace

std::optional<RTCGeometryType> embree_type_of(const Geometry& geometry,
                                              const NormalizedSpace& space,
                                              std::uint32_t primitive) {
    if (geometry.is_instance(primitive)) return std::nullopt;
    const Primitive p = geometry.primitives[primitive];
    if (p.sides != Sides::both) return std::nullopt;
    if (p.kind == kind_of<Triangle>()) return RTC_GEOMETRY_TYPE_TRIANGLE;
    if (p.kind == kind_of<Sphere>()) return RTC_GEOMETRY_TYPE_SPHERE_POINT;
    if (p.kind == kind_of<Polygon>() && is_quad(geometry.get<Polygon>(p), space)) {
        return RTC_GEOMETRY_TYPE_QUAD;
    }
    return std::nullopt;
}

FloatGeometry::FloatGeometry(const EmbreeDevice& device, const Geometry& geometry,
                             const NormalizedSpace& space)
    : device_(device),
      geometry_(geometry),
      space_(space),
      vertices_(float_vertices(device, geometry, space)) {}

EmbreeOwned<RTCGeometry> FloatGeometry::make(RTCGeometryType type,
                                             const std::vector<std::uint32_t>& ids) const {
    EmbreeOwned<RTCGeometry> geometry(rtcNewGeometry(device_.handle(), type));
    device_.check();
    switch (type) {
        case RTC_GEOMETRY_TYPE_TRIANGLE:
            fill_triangles(geometry.get(), ids);
            break;
        case RTC_GEOMETRY_TYPE_QUAD:
            fill_quads(geometry.get(), ids);
            break;
        default:
            fill_spheres(geometry.get(), ids);
    }
    rtcCommitGeometry(geometry.get());
    return geometry;
}

void FloatGeometry::fill_triangles(RTCGeometry geometry,
                                   const std::vector<std::uint32_t>& ids) const {
    rtcSetGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices_.get(), 0,
                         sizeof(Vec3f), vertex_count(geometry_));
    auto* to =
        new_buffer<TriangleIndices>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, ids.size());
    device_.check();
    for (const std::uint32_t id : ids) {
        const auto [a, b, c] = get<Triangle>(id).vertices;
        *to++ = {buffer_index(geometry_, a), buffer_index(geometry_, b),
                 buffer_index(geometry_, c)};
    }
}

void FloatGeometry::fill_quads(RTCGeometry geometry, const std::vector<std::uint32_t>& ids) const {
    rtcSetGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices_.get(), 0,
                         sizeof(Vec3f), vertex_count(geometry_));
    using Corners = std::array<std::uint32_t, 4>;
    auto* to = new_buffer<Corners>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT4, ids.size());
    device_.check();
    for (const std::uint32_t id : ids) {
        const std::uint32_t first = buffer_index(geometry_, get<Polygon>(id));
        *to++ = {first, first + 1, first + 2, first + 3};
    }
}

void FloatGeometry::fill_spheres(RTCGeometry geometry,
                                 const std::vector<std::uint32_t>& ids) const {
    auto* to =
        new_buffer<FloatSphere>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, ids.size());
    device_.check();
    for (const std::uint32_t id : ids) {
        const auto& sphere = get<Sphere>(id);
        const double radius = sphere.radius * space_.scale();
        *to++ = {Vec3f(space_.point(sphere.centre)), static_cast<float>(radius)};
    }
}

}  // namespace etalon
