#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/numerics/affine.h"

namespace etalon {

/// An object placed by an affine map. The object's primitives are stored once, however many
/// instances it has.
///
/// An instance is defined by the numbers below, not by the map from which they were computed: a
/// point p in world space is A (p - origin) in object space, where A has the rows `rows`. In this
/// form nothing cancels far from the world's origin.
struct Instance {
    Instance(const Affine& to_world, std::uint32_t object_number);

    /// Returns the map from object to world space, accurate enough for one step of correction to
    /// leave roundings only; not finite where the rows are singular.
    Affine to_world() const;

    /// Returns the same for bounds: a point's image is off by at most 25 u of its distance from the
    /// origin, times spread() (core/intersect/placement.h). Nothing if a component of the spread
    /// certainly exceeds 2^21, or if products of the rows nearly leave the range of double.
    std::optional<Affine> precise_to_world() const;

    /// Returns whether rays can be transformed to object space. False for a map that is singular or
    /// not finite; its instance is never hit.
    bool exists() const;

    /// Value of `motion` for an instance that does not move.
    static constexpr std::uint32_t still = 0xFFFFFFFFU;

    bool moves() const { return motion != still; }

    std::array<Vec3, 3> rows;  ///< rows of the map's inverse matrix, each number rounded once
    Vec3 origin;               ///< the object's origin in world space
    std::uint32_t object;      ///< number among Geometry::objects
    /// Number among Geometry::motions; then the members above are those at the time at which the
    /// shutter opens.
    std::uint32_t motion = still;
};

static_assert(sizeof(Instance) == 104);

}  // namespace etalon
