#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/numerics/affine.h"
#include "core/parallel/large_pages.h"
#include "core/scene/convexity.h"
#include "core/scene/value_iterator.h"

namespace etalon {

/// Cross section of a curve: a ribbon that faces every ray (flat), one with a normal of its own
/// (ribbon), or one that faces every ray and has the normals of a tube (cylinder).
enum class CurveType : std::uint8_t { flat, ribbon, cylinder };

/// A cubic Bezier curve with a width, in a space of its own.
struct BezierCurve {
    std::array<Vec3f, 4> points;
    std::array<float, 2> widths;                                   ///< at u = 0 and 1
    std::array<Vec3f, 2> normals{Vec3f(0, 0, 1), Vec3f(0, 0, 1)};  ///< unit, at both ends; ribbons
    CurveType type = CurveType::flat;

    bool operator==(const BezierCurve&) const = default;
};

/// One of the equal parts of a curve, in the order of u.
struct CurvePart {
    std::uint32_t number = 0, count = 1;  ///< count: a power of two

    double begin() const { return static_cast<double>(number) / count; }
    double end() const { return static_cast<double>(number + 1) / count; }
};

/// Transforms between a curve's space and world space.
struct CurveTransform {
    explicit CurveTransform(const Affine& map);

    /// Returns whether the map is finite and not singular, as far as doubles show it.
    bool exists() const;

    Affine to_world;
    std::array<Vec3, 3> rows;  ///< rows of the inverse of the map's matrix
    double stretch;            ///< stretch_of() the map

    /// Transforms a direction, or a point minus the map's origin, from world space to the curve's
    /// space.
    Vec3 vector(const Vec3& v) const { return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)}; }
};

/// A part of a curve as kernels see it.
struct StoredCurve {
    const BezierCurve& curve;
    const CurveTransform& place;
    CurvePart part;
};

/// A part of a curve, placed by `to_world`: the points within half the width of the part's points,
/// in a plane perpendicular to the ray that sees them.
struct Curve {
    static constexpr std::string_view name = "curve";
    static constexpr Convexity convexity = Convexity::any;

    Curve(const BezierCurve& of, const Affine& map, CurvePart which = {})
        : curve(of), to_world(map), part(which) {}
    explicit Curve(const StoredCurve& s) : Curve(s.curve, s.place.to_world, s.part) {}

    BezierCurve curve;
    Affine to_world;
    CurvePart part;
};

/// Many parts of curves. A curve is stored once for consecutive parts, and a map once for
/// consecutive curves.
class CurveList {
  public:
    using value_type = Curve;

    std::size_t size() const { return parts_.size(); }
    bool empty() const { return parts_.empty(); }
    void push_back(const Curve& curve);

    StoredCurve operator[](std::size_t i) const {
        const Part& part = parts_[i];
        const Entry& entry = curves_[part.curve];
        return {entry.curve,
                places_[entry.place],
                {part.number & 0xFFFFU, std::uint32_t{1} << (part.number >> 16)}};
    }

    ValueIterator<CurveList> begin() const { return {*this, 0}; }
    ValueIterator<CurveList> end() const { return {*this, size()}; }

    /// Replaces each map by change(map).
    template <class Change>
    void change_maps(const Change& change) {
        for (CurveTransform& place : places_) place = CurveTransform(change(place.to_world));
    }

    void shrink_to_fit();
    std::size_t memory_bytes() const;

    /// Maximum number of parts of a curve.
    static constexpr std::uint32_t most_parts = 1U << 10;

  private:
    struct Entry {
        BezierCurve curve;
        std::uint32_t place;
    };
    struct Part {
        std::uint32_t curve;
        std::uint32_t number;  ///< the upper half is the logarithm of the number of parts
    };

    LargeVector<Part> parts_;
    LargeVector<Entry> curves_;
    LargeVector<CurveTransform> places_;
};

}  // namespace etalon
