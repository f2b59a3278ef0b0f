// Geometry: plain data that a loader fills. Kernels and backends only read it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/numerics/decimal.h"
#include "core/parallel/large_pages.h"
#include "core/scene/animated_transform.h"
#include "core/scene/instance.h"
#include "core/scene/primitive_runs.h"
#include "core/scene/shapes.h"

namespace etalon {

class CutOuts;

/// A point whose coordinates have few decimal digits.
using DecimalVertex = std::array<Decimal, 3>;

/// Bit that marks the number of a vertex with decimal coordinates.
inline constexpr std::uint32_t decimal_vertex = 0x80000000U;

/// Kind of instances, in the numbering of the kinds of primitives.
inline constexpr ShapeKind instance_kind = shape_kinds;
inline constexpr std::size_t item_kinds = shape_kinds + 1;

/// Primitives are numbered in order of appearance; instances have the numbers after the last
/// primitive. Both are items. Where two items are hit at the same distance, the lower number wins,
/// in every backend. Of equally near primitives of one instance, the one with the lower number
/// in its object wins.
struct Geometry {
    PrimitiveRuns primitives;
    ShapeArrays shapes;
    LargeVector<Vec3> vertices, normals;
    LargeVector<DecimalVertex> decimal_vertices;
    LargeVector<std::array<float, 2>> uvs;   ///< texture coordinates of vertices of triangles
    std::vector<Geometry> objects;           ///< only seen as instances; they have none themselves
    LargeVector<Instance> instances;         ///< instances of the objects
    std::vector<AnimatedTransform> motions;  ///< of instances
    /// Holes of cut-out primitives; null if there are none.
    std::shared_ptr<const CutOuts> cut_outs;

    std::uint32_t item_count() const {
        return static_cast<std::uint32_t>(primitives.size() + instances.size());
    }
    bool is_instance(std::uint32_t item) const { return item >= primitives.size(); }
    /// Returns the number, among the instances, of an item that is an instance.
    std::uint32_t instance_number(std::uint32_t item) const {
        return item - static_cast<std::uint32_t>(primitives.size());
    }
    ShapeKind kind_of_item(std::uint32_t item) const {
        return is_instance(item) ? instance_kind : primitives[item].kind;
    }

    /// Returns the geometry that holds the primitives of an instance; this one for no_index.
    const Geometry& holder(std::uint32_t instance) const {
        return instance == no_index ? *this : objects[instances[instance].object];
    }

    Vec3 vertex(std::uint32_t number) const {
        if ((number & decimal_vertex) == 0) return vertices[number];
        const auto& [x, y, z] = decimal_vertices[number & ~decimal_vertex];
        return {x.value(), y.value(), z.value()};
    }

    /// Returns the number of a corner's normal, for a triangle with normals at its corners.
    static std::uint32_t normal_number(const Triangle& t, std::size_t corner) {
        return t.vertices[corner] - t.normal_offset;
    }

    /// Appends a moving instance of an object.
    void add_moving_instance(const AnimatedTransform& motion, std::uint32_t object);

    /// Appends a vertex for triangles. Returns its number.
    std::uint32_t add_vertex(const Vec3& position);

    /// Appends a vertex for the triangles of a large mesh, in as few bytes as possible. Kernels
    /// take longer to read it. Returns its number.
    std::uint32_t add_compact_vertex(const Vec3& position);

    /// Appends a vertex with a normal. Returns its number; the number of the normal is that minus
    /// normal_offset(), as it is after the call.
    std::uint32_t add_vertex(const Vec3& position, const Vec3& normal);

    /// Returns the number of vertices without a normal.
    std::uint32_t normal_offset() const {
        return static_cast<std::uint32_t>(vertices.size() - normals.size());
    }

    template <class Shape>
    auto& all() {
        return std::get<kind_of<Shape>()>(shapes);
    }
    template <class Shape>
    const auto& all() const {
        return std::get<kind_of<Shape>()>(shapes);
    }

    /// Returns the data of a primitive known to be a `Shape`.
    template <class Shape>
    decltype(auto) get(const Primitive& p) const {
        if constexpr (std::is_same_v<Shape, Triangle>) {
            return Triangle{all<Triangle>()[p.index], p.normal_offset};
        } else {
            return all<Shape>()[p.index];
        }
    }

    template <class Shape>
    void add(const Shape& shape, std::uint32_t material, Sides sides = Sides::both) {
        Primitive primitive{kind_of<Shape>(), sides,
                            static_cast<std::uint32_t>(all<Shape>().size()), material};
        if constexpr (std::is_same_v<Shape, Triangle>) {
            primitive.normal_offset = shape.normal_offset;
            all<Triangle>().push_back(shape.vertices);
        } else {
            all<Shape>().push_back(shape);
        }
        primitives.push_back(primitive);
    }
};

/// Appends the primitives and instances of `other`, which must have no texture coordinates.
/// Materials keep their numbers.
void append(Geometry& geometry, const Geometry& other);

/// Releases the unused capacity of the arrays, once a geometry is complete.
void shrink_to_fit(Geometry& geometry);

/// Returns the bytes held by the arrays.
std::size_t memory_bytes(const Geometry& geometry);

}  // namespace etalon
