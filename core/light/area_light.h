// A primitive that emits light: which side of it shines, and how much it may send where.
#pragma once

#include <optional>

#include "core/light/area_shape.h"
#include "core/light/light_bounds.h"
#include "core/scene/scene.h"

namespace etalon {

/// A light made by area_light(), kept small, as there may be millions.
struct AreaLight {
    /// Joins the next primitive, the other half of a quadrilateral, to the light.
    void join(const AreaShape& both);

    /// Returns whether the light shines back along a ray that hits it where it has the normal.
    bool shines(const Vec3& normal, const Vec3& ray) const;

    /// Returns whether a one-sided flat light shines only to the other side of its plane.
    bool turns_from(const Vec3& point) const;

    /// Returns a bound on the cosine between the front's normal and directions to a point; `back`
    /// is relative to the middle of the light.
    double facing(const Vec3& back) const;

    LightBounds light_bounds(const Geometry& geometry) const;

    AreaShape shape;
    Color radiance;
    BoundingSphere bounds;           ///< about a point of its plane, if the light is flat
    std::optional<Vec3> flat_front;  ///< normal of the emitting side, if the light is flat
    double exitance;  ///< area times luminance; 0 for a primitive of a kind that cannot be sampled
    std::uint32_t primitive;
    bool is_joined;  ///< with the next primitive
    bool flipped, two_sided;
    bool is_unseen;  ///< rays pass everywhere, so none can hit the light
};

/// Returns one of the primitives of `source` as a light.
AreaLight area_light(const Scene& scene, const AreaSource& source, std::uint32_t primitive);

}  // namespace etalon
