#pragma once

#include "core/numerics/affine.h"

namespace etalon {

/// Rotations that map a unit shape to itself.
enum class Symmetry { none, about_z, sphere };

/// The coordinates in which the image of a unit shape under an affine map is the unit shape. The
/// shape is first rotated onto itself so that the inverse's rows (all of them for a sphere, the
/// first two for symmetry about z) are nearly orthogonal. Then the rounding of a row, or of a
/// product with it, moves the surface by that fraction of the shape's size, not by that times the
/// map's condition.
class LocalFrame {
  public:
    LocalFrame(const Affine& map, Symmetry symmetry);

    /// Returns whether the map is finite and not singular, which is decided exactly.
    bool exists() const { return exists_; }

    /// Maps from world to local coordinates. Each row of the matrix is good to two roundings of its
    /// length, apart from a distortion of the unit shape by at most 2^-90.
    Vec3 vector(const Vec3& v) const { return {rows_[0].dot(v), rows_[1].dot(v), rows_[2].dot(v)}; }
    const Vec3& row(int k) const { return rows_[k]; }
    double length(int k) const { return lengths_[k]; }  ///< length of a row, rounded up

    /// Maps back to world coordinates. A normal's length is not kept.
    Vec3 point(const Vec3& local) const { return to_world_.point(local); }
    Vec3 normal(const Vec3& local) const {
        return local.x * rows_[0] + local.y * rows_[1] + local.z * rows_[2];
    }

  private:
    Affine to_world_;  ///< after that rotation
    Vec3 rows_[3] = {Vec3(0), Vec3(0), Vec3(0)};
    Vec3 lengths_{0};
    bool exists_ = false;
};

}  // namespace etalon
