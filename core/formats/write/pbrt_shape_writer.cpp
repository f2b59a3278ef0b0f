#include "core/formats/write/pbrt_shape_writer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/formats/outline.h"
#include "core/formats/triangulation.h"
#include "core/formats/write/facets.h"
#include "core/formats/write/pbrt_shapes.h"
#include "core/numerics/transforms.h"

namespace etalon {
namespace {

/// Returns whether the corners lie in a plane, up to about the rounding of PBRT's floats.
bool is_planar(const PolygonFacts& facts) {
    const Vec3& normal = facts.plane.normal;
    const double size = max_abs(facts.box.min) + max_abs(facts.box.max);
    return facts.projection.off_plane <= 1e-6 * size * std::sqrt(normal.dot(normal));
}

/// Returns whether the rounding of PBRT's floats moves a vertex by so much of the mesh's size that
/// it may show.
bool changes_as_floats(std::span<const Vec3> vertices) {
    Box3 box;
    for (const Vec3& v : vertices) box.extendBy(v);
    const double harmless = 0x1p-14 * max_abs(box.size());
    return std::ranges::any_of(
        vertices, [&](const Vec3& v) { return !(max_abs(v - Vec3(Vec3f(v))) <= harmless); });
}

}  // namespace

double distance_to_view_plane(const Camera& camera) {
    const Vec3 view = camera.at - camera.eye;
    return std::sqrt(view.dot(view));
}

void PbrtShapeWriter::primitive(const Geometry& geometry, const Primitive& p) {
    with_shape(p.kind, [&]<class Shape>() { write(geometry.get<Shape>(p)); });
}

/// Leaves out faces without area, which are errors where the file is read strictly.
void PbrtShapeWriter::mesh(std::span<const Vec3> vertices, std::span<const Vec3> normals,
                           std::span<const Face> faces) {
    if (changes_as_floats(vertices)) {
        lost_.add("mesh that is too small for its distance from the origin");
    }
    const auto has_area = [&](const Face& face) {
        const auto stored = [&](std::uint32_t i) { return Vec3(Vec3f(vertices[i])); };
        const Vec3 a = stored(face[0]);
        return (stored(face[1]) - a).cross(stored(face[2]) - a) != Vec3(0);
    };
    if (std::ranges::none_of(faces, has_area)) return;
    out_.line("Shape \"trianglemesh\" \"integer indices\" [");
    for (const auto& face : faces) {
        if (has_area(face)) out_.line("{} {} {}", face[0], face[1], face[2]);
    }
    out_.line("] \"point P\" [");
    for (const Vec3& v : vertices) out_.line("{}", v);
    if (!normals.empty()) out_.line("] \"normal N\" [");
    for (const Vec3& n : normals) out_.line("{}", n);
    out_.line("]");
}

/// PBRT's matrices are column by column.
void PbrtShapeWriter::placed(const Affine& to_world, std::string_view statement) {
    const auto& [x, y, z, origin] = to_world;
    out_.line("TransformBegin\nTransform [ {} 0  {} 0  {} 0  {} 1 ]", x, y, z, origin);
    out_.line("{}", statement);
    out_.line("TransformEnd");
}

void PbrtShapeWriter::write(const Sphere& s) {
    Affine place;
    place.origin = s.centre;
    placed(place, fmt::format("Shape \"sphere\" \"float radius\" [ {} ]", s.radius));
}

void PbrtShapeWriter::write(const Ellipsoid& e) {
    placed(e.to_world, "Shape \"sphere\" \"float radius\" [ 1 ]");
}

void PbrtShapeWriter::write(const ClosedCylinder& c) {
    placed(c.to_world,
           "Shape \"cylinder\" \"float radius\" [ 1 ] \"float zmin\" [ 0 ] \"float zmax\" "
           "[ 1 ]\nShape \"disk\" \"float height\" [ 0 ] \"float radius\" [ 1 ]\n"
           "Shape \"disk\" \"float height\" [ 1 ] \"float radius\" [ 1 ]");
}

void PbrtShapeWriter::write(const Ring& r) {
    placed(about_axis(r.centre, r.normal),
           fmt::format("Shape \"disk\" \"float radius\" [ {} ] \"float innerradius\" [ {} ]",
                       r.outer, r.inner));
}

void PbrtShapeWriter::write(const Quadric&) {
    lost_.add("quadric, left out");
}

void PbrtShapeWriter::write(const Revolved& s) {
    if (const std::optional<PbrtShape> shape = to_pbrt(s)) {
        placed(shape->to_world, shape->statement);
    } else {
        lost_.add("surface of revolution of no shape that PBRT has, left out");
    }
}

/// Writes a curve with the first of its parts.
void PbrtShapeWriter::write(const StoredCurve& c) {
    if (c.part.number > 0) return;
    const PbrtShape shape = to_pbrt(c);
    placed(shape.to_world, shape.statement);
}

void PbrtShapeWriter::write(const Cone& c) {
    const Vec3 axis = c.top - c.base;
    const double height = std::sqrt(axis.dot(axis));
    const Affine map = about_axis(c.base, axis);
    if (c.base_radius == c.top_radius) {
        placed(map, fmt::format("Shape \"cylinder\" \"float radius\" [ {} ] \"float zmin\" [ 0 ] "
                                "\"float zmax\" [ {} ]",
                                c.base_radius, height));
    } else if (c.top_radius == 0) {
        placed(map, fmt::format("Shape \"cone\" \"float radius\" [ {} ] \"float height\" [ {} ]",
                                c.base_radius, height));
    } else if (c.base_radius == 0) {
        write(Cone{c.top, c.base, c.top_radius, 0});
    } else {
        lost_.add("truncated cone, now triangles");
        write_facets(c);
    }
}

/// Writes smooth facets of four corners as one mesh: PBRT's hyperboloid lies on both sides of its
/// waist and cannot be a cone without its apex.
void PbrtShapeWriter::write_facets(const Cone& cone) {
    std::vector<Vec3> vertices, normals;
    std::vector<Face> faces;
    to_facets(cone, [&](std::span<const Vec3> corners, std::span<const Vec3> corner_normals) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), corners.begin(), corners.end());
        normals.insert(normals.end(), corner_normals.begin(), corner_normals.end());
        faces.push_back({first, first + 1, first + 2});
        faces.push_back({first, first + 2, first + 3});
    });
    mesh(vertices, normals, faces);
}

/// Writes a box without extent along an axis as one face, not as two and four without area.
void PbrtShapeWriter::write(const Box& b) {
    std::vector<Vec3> corners;
    corners.reserve(8);
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y,
                             (i & 4) != 0 ? b.max.z : b.min.z);
    }
    static constexpr std::array<Face, 12> faces = {{{0, 2, 3},
                                                    {0, 3, 1},
                                                    {4, 5, 7},
                                                    {4, 7, 6},
                                                    {0, 1, 5},
                                                    {0, 5, 4},
                                                    {2, 6, 7},
                                                    {2, 7, 3},
                                                    {0, 4, 6},
                                                    {0, 6, 2},
                                                    {1, 3, 7},
                                                    {1, 7, 5}}};
    std::span<const Face> seen = faces;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int k = static_cast<int>(axis);
        if (b.min[k] == b.max[k]) seen = std::span(faces).subspan(4 * (2 - axis), 2);
    }
    mesh(corners, {}, seen);
}

/// PBRT has triangles in place of polygons, and interpolates normals over each of them.
void PbrtShapeWriter::write(const StoredPolygon& p) {
    if (!p.normals.empty()) lost_.add("smooth polygon, now triangles");
    if (!is_planar(p.facts)) lost_.add("polygon that is not planar, now triangles");
    if (crosses_itself(projected_outline(p.corners))) {
        lost_.add("polygon that crosses itself, now triangles that cover other parts");
    }
    mesh(p.corners, p.normals, triangulate(p.corners));
}

/// Writes a square about the point nearest to the eye, as large as a thousand times all distances
/// of the camera.
void PbrtShapeWriter::write(const Plane& p) {
    lost_.add("infinite plane, now a large square");
    const Vec3 normal = normalized(p.normal);
    const double away = normal.dot(camera_.eye - p.point);
    const double side = 1000 * (distance_to_view_plane(camera_) + std::abs(away));
    Affine map;
    orthonormal_basis(normal, map.x, map.y);
    const Vec3 centre = camera_.eye - away * normal, x = side * map.x, y = side * map.y;
    const std::array corners = {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
    static constexpr std::array<Face, 2> faces = {{{0, 1, 2}, {0, 2, 3}}};
    mesh(corners, {}, faces);
}

}  // namespace etalon
