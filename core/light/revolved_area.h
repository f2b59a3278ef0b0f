#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/light/area_point.h"
#include "core/scene/revolved.h"

namespace etalon {

/// A surface of revolution, sampled by the area that it has before its map: evenly around the axis
/// and in each of some slices of its height, which are chosen by their area. pbrt-v3 samples its
/// cylinder like this, takes whole spheres and disks for their parts, and stops at the others.
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

    /// A height, or the square of a radius in the plane: what is chosen evenly in each slice.
    struct Place {
        double along, density;
    };
    Place choose(double number) const;
    double density_at(double along) const;
    double along_of(const Vec3& local) const;
    double slice_begin(std::size_t slice) const {
        return begin_ + (end_ - begin_) * static_cast<double>(slice) / slices;
    }
    double area_of_slice(double middle) const;
    double image_of_slice(double middle) const;

    Vec3 point(double along, double around) const;

    /// Normal, as long as the area there is stretched by the map and by the way the surface is
    /// parametrized: by the angle and what is chosen evenly.
    Vec3 stretched_normal(const Vec3& local) const;
    double per_area(const Vec3& local, double density) const;

    using Shares = std::array<double, slices + 1>;

    // Apart, so that the light of another shape, of which there may be millions, is small.
    std::shared_ptr<const Revolved> surface_;
    std::shared_ptr<const Shares> cumulative_;  ///< of the slices' areas, from 0 to 1
    Vec3 cofactors_[3];  ///< columns of the matrix that takes areas before the map to the image's
    double begin_, end_;
    double area_ = 0;
};

}  // namespace etalon
