#pragma once

#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {

/// A shape on its way to primitives: where it goes, and what it has in common with others.
class ShapeBuilder {
  public:
    /// `map` takes the shape into the space of its geometry: the world's or an object's.
    ShapeBuilder(SceneBuilder& builder, const pbrt::Shape& of, const Affine& map)
        : b(builder), shape(of), to_world(map), swaps_hand_(map.determinant() < 0) {}

    SceneBuilder& b;
    const pbrt::Shape& shape;
    const Affine to_world;

    const Parameters& parameters() const { return shape.plugin.parameters; }
    Geometry& geometry() const { return b.geometry(); }

    /// A point of the shape in the world, with the digits of a float, as pbrt-v3 keeps it.
    Vec3 point(const Vec3f& p) const { return Vec3(Vec3f(to_world.point(Vec3(p)))); }

    /// The normal, as long as it is, across the image of what `n` is across.
    Vec3 normal(const Vec3& n) const;

    /// Returns whether normals of the format are opposite to those that point outward from a closed
    /// shape, and to those that the winding of corners gives.
    bool flips_normals() const { return shape.reverse_orientation != swaps_hand_; }

    /// Returns whether its material asks for surface coordinates: shows a texture, or has a grain.
    bool needs_coordinates() const;

    /// Begins a run of primitives: makes their binding, or takes that of the shape before.
    void begin(SurfaceBinding binding);

    /// Adds a primitive of the run, and the light that it is.
    template <class Shape>
    void add(const Shape& primitive) {
        add_light();
        geometry().add(primitive, binding_, sides_);
    }

    /// Nothing of the shape is shown.
    void skip(std::string_view why) const;

  private:
    void add_light();

    bool swaps_hand_;  ///< the map mirrors
    std::uint32_t binding_ = 0;
    Sides sides_ = Sides::both;
};

/// Triangles with what a mesh knows of their corners; n vertices.
struct MeshData {
    std::span<const float> points;             ///< 3n
    std::span<const float> normals{};          ///< 3n or none
    std::span<const float> uvs{};              ///< 2n or none
    std::span<const std::uint32_t> corners{};  ///< three for each triangle, each below n
    bool flipped = false;  ///< the format's normals are opposite to those of the corners
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
