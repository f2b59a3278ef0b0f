// The shapes of scenes: plain data, in world coordinates. CONTRIBUTING.md lists the steps to add a
// shape; the compiler reports most that are missing.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "core/numerics/local_frame.h"
#include "core/numerics/vec.h"
#include "core/parallel/large_pages.h"
#include "core/scene/convexity.h"
#include "core/scene/curve_list.h"
#include "core/scene/polygon_list.h"
#include "core/scene/revolved.h"
#include "core/scene/triangle_list.h"

namespace etalon {

inline constexpr std::uint32_t no_index = 0xFFFFFFFFU;

struct Sphere {
    static constexpr std::string_view name = "sphere";
    static constexpr Convexity convexity = Convexity::convex;
    Vec3 centre;
    double radius;  ///< > 0; spheres visible only from inside have Sides::back
};

/// Triangle, as the numbers of its corners among the geometry's vertices. The front is where the
/// corners run counter-clockwise.
struct Triangle {
    static constexpr std::string_view name = "triangle";
    static constexpr Convexity convexity = Convexity::flat;
    TriangleIndices vertices;
    std::uint32_t normal_offset = no_index;  ///< see Primitive
};

/// An axis-aligned box, both sides visible; min <= max in each axis.
struct Box {
    static constexpr std::string_view name = "box";
    static constexpr Convexity convexity = Convexity::convex;
    Vec3 min, max;
};

/// The infinite plane through `point`; `normal` need not be of unit length.
struct Plane {
    static constexpr std::string_view name = "plane";
    static constexpr Convexity convexity = Convexity::flat;
    Vec3 point, normal;
};

/// The lateral surface between two circles about the line base-top: a cylinder if the radii are
/// equal, a cone if one is zero. Without caps.
struct Cone {
    static constexpr std::string_view name = "cone";
    static constexpr Convexity convexity = Convexity::convex;
    Vec3 base, top;
    double base_radius, top_radius;
};

/// The part of a plane between two circles, which belong to it: inner <= |p - centre| <= outer.
/// The front is where the normal points; it need not be of unit length.
struct Ring {
    static constexpr std::string_view name = "ring";
    static constexpr Convexity convexity = Convexity::flat;
    Vec3 centre, normal;
    double inner, outer;  ///< 0 <= inner <= outer, outer > 0
};

/// The points with a x^2 + 2b xy + 2c xz + 2d x + e y^2 + 2f yz + 2g y + h z^2 + 2i z + j = 0 for
/// (x, y, z) = p - centre that are in the box `clip`. The faces belong to the box: a surface that
/// just touches them is whole, and two boxes that share a face both have the surface there, at the
/// same points, so no ray slips through between them. The front is where the form is positive.
///
/// A form whose quadratic part is a square, such as (x - 1)^2, is hit where it vanishes, like its
/// plane; x^2 + y^2 is hit by lines that pass exactly through the axis. A line that lies in the
/// surface does not hit it.
struct Quadric {
    static constexpr std::string_view name = "quadric";
    static constexpr Convexity convexity = Convexity::any;
    Vec3 centre;
    std::array<double, 10> coefficients;  ///< a, b, ... j
    Box3 clip;
};

/// The image of the unit sphere about the origin under `to_world`.
struct Ellipsoid {
    static constexpr std::string_view name = "ellipsoid";
    static constexpr Convexity convexity = Convexity::convex;

    explicit Ellipsoid(const Affine& map) : to_world(map), frame(map, Symmetry::sphere) {}

    Affine to_world;
    LocalFrame frame;
};

/// The image of the solid cylinder x^2 + y^2 <= 1, 0 <= z <= 1 under `to_world`: its side and both
/// caps.
struct ClosedCylinder {
    static constexpr std::string_view name = "cylinder";
    static constexpr Convexity convexity = Convexity::convex;

    explicit ClosedCylinder(const Affine& map) : to_world(map), frame(map, Symmetry::about_z) {}

    Affine to_world;
    LocalFrame frame;
};

/// One array per kind of shape. A kind's number is its place in this list; triangles are in an
/// array of fewer bytes, polygons in one that keeps what their corners give, and parts of curves in
/// one that stores a curve once.
using ShapeArrays =
    std::tuple<LargeVector<Sphere>, TriangleList, PolygonList, LargeVector<Box>, LargeVector<Plane>,
               LargeVector<Cone>, LargeVector<Ring>, LargeVector<Quadric>, LargeVector<Ellipsoid>,
               LargeVector<ClosedCylinder>, LargeVector<Revolved>, CurveList>;

inline constexpr std::size_t shape_kinds = std::tuple_size_v<ShapeArrays>;

using ShapeKind = std::uint8_t;

template <class Array>
struct ShapeOfArray {
    using type = typename Array::value_type;
};
template <>
struct ShapeOfArray<TriangleList> {
    using type = Triangle;
};

template <std::size_t Kind>
using ShapeOfKind = typename ShapeOfArray<std::tuple_element_t<Kind, ShapeArrays>>::type;

/// The number of the kind `Shape`; fails to compile for what is not in the list.
template <class Shape, std::size_t Kind = 0>
constexpr ShapeKind kind_of() {
    if constexpr (std::is_same_v<Shape, ShapeOfKind<Kind>>) {
        return static_cast<ShapeKind>(Kind);
    } else {
        return kind_of<Shape, Kind + 1>();
    }
}

/// Calls f.template operator()<Shape>() for the shape of number `kind`.
template <std::size_t Kind = 0, class F>
decltype(auto) with_shape(ShapeKind kind, F&& f) {
    if constexpr (Kind + 1 == shape_kinds) {
        return f.template operator()<ShapeOfKind<Kind>>();
    } else {
        if (kind == Kind) return f.template operator()<ShapeOfKind<Kind>>();
        return with_shape<Kind + 1>(kind, std::forward<F>(f));
    }
}

/// Returns the name of a kind: "sphere", "triangle", ...
inline std::string_view kind_name(ShapeKind kind) {
    return with_shape(kind, []<class Shape>() { return Shape::name; });
}

}  // namespace etalon
