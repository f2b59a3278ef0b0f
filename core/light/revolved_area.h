#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/light/area_point.h"
#include "core/scene/revolved.h"

namespace etalon {

/// A surface of revolution, sampled by its area before its map is applied: uniformly around the
/// axis and in each of some slices of its height, which are sampled by their area. pbrt-v3 samples
/// its cylinder like this, whole spheres and disks instead of their parts, and aborts for the
/// others.
class RevolvedArea {
  public:
    explicit RevolvedArea(const Revolved& surface);

    AreaPoint sample(const Vec3& from, const Vec2& uv) const;
    double pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const;
    double area() const { return area_; }
    BoundingSphere bounds() const;
    std::optional<Vec3> flat_normal() const;

  private:
    static constexpr std::size_t slices = 64;

    /// A height, or the square of a radius in the plane: the uniformly sampled variable of a slice.
    struct SlicePoint {
        double along, density;
    };
    SlicePoint choose(double number) const;
    double density_at(double along) const;
    double along_of(const Vec3& local) const;
    double slice_begin(std::size_t slice) const {
        return begin_ + (end_ - begin_) * static_cast<double>(slice) / slices;
    }
    double area_of_slice(double middle) const;
    double image_of_slice(double middle) const;

    Vec3 point(double along, double around) const;

    /// Returns the normal times the factor by which the map and the parametrization, by the angle
    /// and the uniformly sampled variable, stretch areas there.
    Vec3 stretched_normal(const Vec3& local) const;
    double per_area(const Vec3& local, double density) const;

    using Shares = std::array<double, slices + 1>;

    // Stored separately, so that area lights of other shapes, of which there may be millions, are
    // small.
    std::shared_ptr<const Revolved> surface_;
    std::shared_ptr<const Shares> cumulative_;  ///< of the slices' areas, from 0 to 1
    Vec3 cofactors_[3];  ///< columns of the matrix that maps areas before the map to the image
    double begin_, end_;
    double area_ = 0;
};

}  // namespace etalon
