#include "core/scene/geometry.h"

#include "core/scene/spare_room.h"

namespace etalon {
namespace {

template <class T>
std::size_t memory_bytes(const LargeVector<T>& v) {
    return written_bytes(v);
}

std::size_t memory_bytes(const TriangleList& triangles) {
    return triangles.memory_bytes();
}

std::size_t memory_bytes(const PolygonList& polygons) {
    return polygons.memory_bytes();
}

std::size_t memory_bytes(const CurveList& curves) {
    return curves.memory_bytes();
}

}  // namespace

void Geometry::add_moving_instance(const AnimatedTransform& motion, std::uint32_t object) {
    instances.emplace_back(motion.at(0), object).motion =
        static_cast<std::uint32_t>(motions.size());
    motions.push_back(motion);
}

std::uint32_t Geometry::add_vertex(const Vec3& position) {
    vertices.push_back(position);
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

std::uint32_t Geometry::add_compact_vertex(const Vec3& position) {
    const auto x = Decimal::from(position.x), y = Decimal::from(position.y),
               z = Decimal::from(position.z);
    if (x && y && z) {
        decimal_vertices.push_back({*x, *y, *z});
        return static_cast<std::uint32_t>(decimal_vertices.size() - 1) | decimal_vertex;
    }
    return add_vertex(position);
}

std::uint32_t Geometry::add_vertex(const Vec3& position, const Vec3& normal) {
    vertices.push_back(position);
    normals.push_back(normal);
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

namespace {

/// Copies shapes from one geometry to the end of another.
class Appender {
  public:
    explicit Appender(Geometry& to)
        : to_(to),
          vertices_(static_cast<std::uint32_t>(to.vertices.size())),
          decimal_vertices_(static_cast<std::uint32_t>(to.decimal_vertices.size())),
          normals_(static_cast<std::uint32_t>(to.normals.size())) {}

    template <class Shape>
    void operator()(Shape shape, const Primitive& p) const {
        renumber(shape);
        to_.add(shape, p.material, p.sides);
    }

  private:
    void renumber(Triangle& t) const {
        for (std::uint32_t& v : t.vertices) {
            v += (v & decimal_vertex) != 0 ? decimal_vertices_ : vertices_;
        }
        if (t.normal_offset != no_index) t.normal_offset += vertices_ - normals_;
    }
    template <class Shape>
    void renumber(Shape&) const {}

    Geometry& to_;
    std::uint32_t vertices_, decimal_vertices_, normals_;  ///< numbers of the first appended ones
};

template <class T>
void append(LargeVector<T>& to, const LargeVector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void append(Geometry& geometry, const Geometry& other) {
    const Appender add(geometry);
    for (const Primitive p : other.primitives) {
        with_shape(p.kind, [&]<class Shape>() { add(Shape(other.get<Shape>(p)), p); });
    }
    append(geometry.vertices, other.vertices);
    append(geometry.decimal_vertices, other.decimal_vertices);
    append(geometry.normals, other.normals);
    const auto objects = static_cast<std::uint32_t>(geometry.objects.size());
    geometry.objects.insert(geometry.objects.end(), other.objects.begin(), other.objects.end());
    const auto motions = static_cast<std::uint32_t>(geometry.motions.size());
    geometry.motions.insert(geometry.motions.end(), other.motions.begin(), other.motions.end());
    for (Instance instance : other.instances) {
        instance.object += objects;
        if (instance.moves()) instance.motion += motions;
        geometry.instances.push_back(instance);
    }
}

namespace {

void release_spare_capacity(TriangleList& triangles) {
    triangles.shrink_to_fit();
}

void release_spare_capacity(PolygonList& polygons) {
    polygons.shrink_to_fit();
}

void release_spare_capacity(CurveList& curves) {
    curves.shrink_to_fit();
}

}  // namespace

void shrink_to_fit(Geometry& g) {
    std::apply([](auto&... list) { (release_spare_capacity(list), ...); }, g.shapes);
    g.primitives.shrink_to_fit();
    release_spare_capacity(g.vertices);
    release_spare_capacity(g.normals);
    release_spare_capacity(g.decimal_vertices);
    release_spare_capacity(g.uvs);
    release_spare_capacity(g.instances);
    g.motions.shrink_to_fit();
    for (Geometry& object : g.objects) shrink_to_fit(object);
}

std::size_t memory_bytes(const Geometry& g) {
    const std::size_t shapes =
        std::apply([](const auto&... v) { return (memory_bytes(v) + ...); }, g.shapes);
    std::size_t objects = g.objects.capacity() * sizeof(Geometry);
    for (const Geometry& object : g.objects) objects += memory_bytes(object);
    return shapes + g.primitives.memory_bytes() + memory_bytes(g.vertices) +
           memory_bytes(g.normals) + memory_bytes(g.decimal_vertices) + memory_bytes(g.uvs) +
           memory_bytes(g.instances) + g.motions.capacity() * sizeof(AnimatedTransform) + objects;
}

}  // namespace etalon
