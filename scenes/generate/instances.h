// Objects of triangles, and where they are seen, as statements of PBRT v3.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/formats/write/text.h"

namespace etalon::generate {

/// A mesh in the making; its corners are floats, as PBRT reads them.
class Mesh {
  public:
    std::uint32_t add(const Vec3& point) {
        points_.emplace_back(point);
        return static_cast<std::uint32_t>(points_.size() - 1);
    }
    void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        faces_.push_back({a, b, c});
    }

    /// Adds a triangle with corners of its own.
    void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c);

    /// Adds the sides of a prism about the y axis that stands at `low` and narrows upward,
    /// to a tip where `high_radius` is 0.
    void add_prism(std::uint32_t sides, double low, double high, double low_radius,
                   double high_radius);

    /// Writes it as the next shape.
    void write(LineWriter& out) const;

  private:
    std::vector<Vec3f> points_;
    std::vector<std::array<std::uint32_t, 3>> faces_;
};

/// A map of PBRT's: where the axes and the origin of the object go.
struct InstanceTransform {
    Vec3 x, y, z, origin;
};

/// Writes the statements up to WorldBegin and the lights: the sun and the sky.
void begin_world(LineWriter& out, const Vec3& eye, const Vec3& at, double fov_degrees);

/// Writes a diffuse material for what follows.
void matte(LineWriter& out, const Color& color);

/// Writes the instance of an object, called by its number.
void write_instance(LineWriter& out, std::uint32_t object, const InstanceTransform& place);

/// Writes a square of the ground, y = 0, about the origin.
void write_ground(LineWriter& out, double half);

}  // namespace etalon::generate
