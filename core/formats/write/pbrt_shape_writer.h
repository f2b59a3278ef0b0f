#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/formats/write/conversion_warnings.h"
#include "core/formats/write/text.h"
#include "core/scene/camera.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns the distance from a camera to its view plane.
double distance_to_view_plane(const Camera& camera);

/// Writes shapes as statements of PBRT.
class PbrtShapeWriter {
  public:
    using Face = std::array<std::uint32_t, 3>;

    /// `camera` decides how large a square stands for an infinite plane, which PBRT lacks.
    PbrtShapeWriter(LineWriter& out, ConversionWarnings& lost, const Camera& camera)
        : out_(out), lost_(lost), camera_(camera) {}

    /// Writes a primitive that is not a triangle: these are written as meshes.
    void primitive(const Geometry& geometry, const Primitive& p);

    /// Writes a triangle mesh. There is a normal for each vertex, or none.
    void mesh(std::span<const Vec3> vertices, std::span<const Vec3> normals,
              std::span<const Face> faces);

    /// Writes a statement with a transform that is valid for it only.
    void placed(const Affine& to_world, std::string_view statement);

  private:
    void write(const Triangle&) {}
    void write(const Sphere& s);
    void write(const Ellipsoid& e);
    void write(const ClosedCylinder& c);
    void write(const Ring& r);
    void write(const Quadric&);
    void write(const Revolved& s);
    void write(const StoredCurve& c);
    void write(const Cone& c);
    void write(const Box& b);
    void write(const StoredPolygon& p);
    void write(const Plane& p);
    void write_facets(const Cone& cone);

    LineWriter& out_;
    ConversionWarnings& lost_;
    const Camera& camera_;
};

}  // namespace etalon
