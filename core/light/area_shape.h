// Shapes of area lights, as seen from a point: sampling of directions to them, and the densities.
#pragma once

#include <optional>
#include <variant>

#include "core/light/revolved_area.h"
#include "core/light/triangle_area.h"
#include "core/numerics/affine.h"
#include "core/scene/geometry.h"

namespace etalon {

/// A sphere, sampled by its cone of directions from outside, by its area from inside.
class SphereArea {
  public:
    explicit SphereArea(const Sphere& sphere) : sphere_(sphere) {}

    AreaPoint sample(const Vec3& from, const Vec2& uv) const;
    double pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const;
    double area() const;
    BoundingSphere bounds() const { return {sphere_.centre, sphere_.radius}; }
    std::optional<Vec3> flat_normal() const { return std::nullopt; }

  private:
    /// Returns 1 - cosine of the half angle of the cone that contains the sphere; nothing from
    /// inside and from just above the surface.
    std::optional<double> cone(const Vec3& from) const;

    Sphere sphere_;
};

/// A ring or a disk, sampled by its area.
class RingArea {
  public:
    explicit RingArea(const Ring& ring);

    AreaPoint sample(const Vec3& from, const Vec2& uv) const;
    double pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const;
    double area() const { return area_; }
    BoundingSphere bounds() const { return {ring_.centre, ring_.outer}; }
    std::optional<Vec3> flat_normal() const { return ring_.normal; }

  private:
    Ring ring_;
    double area_;
};

/// The image of a sphere, sampled by the area of the sphere.
class EllipsoidArea {
  public:
    explicit EllipsoidArea(const Affine& to_world);

    AreaPoint sample(const Vec3& from, const Vec2& uv) const;
    double pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const;
    double area() const { return area_; }
    BoundingSphere bounds() const;
    std::optional<Vec3> flat_normal() const { return std::nullopt; }

  private:
    /// Returns the normal times the factor by which the map stretches areas at a point.
    Vec3 stretched_normal(const Vec3& unit) const;

    Affine to_world_;
    double area_;
};

using AreaShape =
    std::variant<TriangleArea, TwoTrianglesArea, SphereArea, RingArea, EllipsoidArea, RevolvedArea>;

/// Returns the primitive as the shape of an area light; nothing for kinds that cannot be sampled.
std::optional<AreaShape> area_shape(const Geometry& geometry, std::uint32_t primitive);

/// Returns a primitive and the next one as one shape, if they are the halves of a quadrilateral.
std::optional<TwoTrianglesArea> quadrilateral(const Geometry& geometry, std::uint32_t primitive);

}  // namespace etalon
