#pragma once

#include "core/numerics/affine.h"

namespace etalon {

/// How a unit shape may be turned about itself and stay the same.
enum class Symmetry { none, about_z, sphere };

/// The coordinates in which the image of a unit shape under an affine map is the unit shape. It is
/// first turned about itself, so that the inverse's rows (of a sphere all, of what is round about z
/// the first two) are nearly at right angles: rounding a row or a product with it then moves the
/// surface by as much of the shape's size, and not by that times the map's condition.
class LocalFrame {
  public:
    LocalFrame(const Affine& map, Symmetry symmetry);

    /// Returns whether the map is finite and not singular, which is found out exactly.
    bool exists() const { return exists_; }

    /// Maps from the world to local coordinates. Each row of the matrix is good to two roundings of
    /// its length, but for a distortion of the unit shape by 2^-90 and less.
    Vec3 vector(const Vec3& v) const { return {rows_[0].dot(v), rows_[1].dot(v), rows_[2].dot(v)}; }
    const Vec3& row(int k) const { return rows_[k]; }
    double length(int k) const { return lengths_[k]; }  ///< length of a row, rounded up

    /// Maps back to the world. A normal's length is not kept.
    Vec3 point(const Vec3& local) const { return to_world_.point(local); }
    Vec3 normal(const Vec3& local) const {
        return local.x * rows_[0] + local.y * rows_[1] + local.z * rows_[2];
    }

  private:
    Affine to_world_;  ///< after the turn
    Vec3 rows_[3] = {Vec3(0), Vec3(0), Vec3(0)};
    Vec3 lengths_{0};
    bool exists_ = false;
};

}  // namespace etalon
