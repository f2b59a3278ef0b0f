#pragma once

#include <optional>

#include "core/light/area_point.h"

namespace etalon {

/// A triangle, sampled by its solid angle if that is neither too small nor too large for the
/// arithmetic (Arvo 1995, "Stratified Sampling of Spherical Triangles"), else by its area.
class TriangleArea {
  public:
    TriangleArea(const Vec3& a, const Vec3& b, const Vec3& c);

    AreaPoint sample(const Vec3& from, const Vec2& uv) const;
    double pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const;
    double area() const { return area_; }
    BoundingSphere bounds() const;
    std::optional<Vec3> flat_normal() const { return normal_; }

  private:
    Vec3 a_, b_, c_, normal_;
    double area_;
};

/// Two triangles a b c and a c d in one plane, sampled like one shape.
class TwoTrianglesArea {
  public:
    TwoTrianglesArea(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

    AreaPoint sample(const Vec3& from, const Vec2& uv) const;
    double pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const;
    double area() const { return area_; }
    BoundingSphere bounds() const;
    std::optional<Vec3> flat_normal() const { return normal_; }

  private:
    Vec3 centre() const;

    Vec3 a_, b_, c_, d_, normal_;
    double first_area_, area_;
};

}  // namespace etalon
