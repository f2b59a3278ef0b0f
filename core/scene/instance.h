#pragma once

#include <array>
#include <cstdint>

#include "core/numerics/affine.h"

namespace etalon {

/// An object that is seen where an affine map puts it. The object's primitives are stored once,
/// however many instances it has.
///
/// The instance is defined by the numbers below, not by the map they were made from: a point p of
/// the world is at A (p - origin) of the object, where A has the rows `rows`. Nothing cancels in
/// that far from the world's origin.
struct Instance {
    Instance(const Affine& to_world, std::uint32_t object_number);

    /// Returns the map from the object to the world, up to roundings; not finite where the rows are
    /// singular.
    Affine to_world() const;

    /// Whether rays can be taken into the object: false for a map that is singular or not finite,
    /// whose instance nothing hits.
    bool exists() const;

    /// Number of the motion of what stands still.
    static constexpr std::uint32_t still = 0xFFFFFFFFU;

    bool moves() const { return motion != still; }

    std::array<Vec3, 3> rows;  ///< of the inverse of the map's matrix, each number rounded once
    Vec3 origin;               ///< point of the world at which the object's origin is
    std::uint32_t object;      ///< number among Geometry::objects
    /// Number among Geometry::motions; the numbers above are then those of the time at which the
    /// shutter opens.
    std::uint32_t motion = still;
};

static_assert(sizeof(Instance) == 104);

}  // namespace etalon
