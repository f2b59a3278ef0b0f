#pragma once

#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {

/// Converts a shape to primitives: holds its transform and the data that it shares with others.
class ShapeBuilder {
  public:
    /// `map` transforms the shape to the space of its geometry: that of the world or of an object.
    ShapeBuilder(SceneBuilder& builder, const pbrt::Shape& of, const Affine& map)
        : b(builder), shape(of), to_world(map), swaps_hand_(map.determinant() < 0) {}

    SceneBuilder& b;
    const pbrt::Shape& shape;
    const Affine to_world;

    const Parameters& parameters() const { return shape.plugin.parameters; }
    Geometry& geometry() const { return b.geometry(); }

    /// Returns a point of the shape in the world, in float precision, as pbrt-v3 stores it.
    Vec3 point(const Vec3f& p) const { return Vec3(Vec3f(to_world.point(Vec3(p)))); }

    /// Returns the normal of the image of a surface with the normal `n`, keeping its length.
    Vec3 normal(const Vec3& n) const;

    /// Returns whether the format's normals are opposite to those that point outward from a closed
    /// shape, and to those of the winding order.
    bool flips_normals() const { return shape.reverse_orientation != swaps_hand_; }

    /// Returns whether the material needs surface coordinates: has textures or is anisotropic.
    bool needs_coordinates() const;

    /// Begins a run of primitives with a new binding, or with that of the previous shape if equal.
    void begin(SurfaceBinding binding);

    /// Adds a primitive to the run, and to its light if it is one.
    template <class Shape>
    void add(const Shape& primitive) {
        add_to_light();
        geometry().add(primitive, binding_, sides_);
    }

    /// Warns that the shape is left out.
    void skip(std::string_view why) const;

  private:
    void add_to_light();

    bool swaps_hand_;  ///< the map mirrors
    std::uint32_t binding_ = 0;
    Sides sides_ = Sides::both;
};

/// Triangles with the data of their n vertices.
struct MeshData {
    std::span<const float> points;             ///< 3n
    std::span<const float> normals{};          ///< 3n or none
    std::span<const float> uvs{};              ///< 2n or none
    std::span<const std::uint32_t> corners{};  ///< three for each triangle, each below n
    bool flipped = false;  ///< the format's normals are opposite to those of the winding order
};

void build_mesh(ShapeBuilder& s, const MeshData& mesh);

void build_triangle_mesh(ShapeBuilder& s);
void build_ply_mesh(ShapeBuilder& s);
void build_loop_subdivision(ShapeBuilder& s);
void build_heightfield(ShapeBuilder& s);
void build_nurbs(ShapeBuilder& s);

void build_sphere(ShapeBuilder& s);
void build_disk(ShapeBuilder& s);
void build_cylinder(ShapeBuilder& s);
void build_cone(ShapeBuilder& s);
void build_paraboloid(ShapeBuilder& s);
void build_hyperboloid(ShapeBuilder& s);

void build_curve(ShapeBuilder& s);

}  // namespace etalon::pbrt
