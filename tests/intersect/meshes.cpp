#include "tests/intersect/meshes.h"

namespace etalon {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Rows of vertices from pole to pole; every row is closed, and a pole is a single vertex.
struct Corners {
    Vec3 at(int ring, int segment) const {
        const double polar = pi * ring / rings;
        const double angle = pi * (segment % (2 * rings)) / rings;
        const double sine = ring % rings == 0 ? 0 : std::sin(polar);
        const Vec3 unit(sine * std::cos(angle), sine * std::sin(angle), std::cos(polar));
        return Vec3(Vec3f(centre + radius * unit));
    }

    Vec3 centre, radius;
    int rings;
};

void add_face(ClosedMesh& mesh, const std::vector<Vec3>& corners) {
    mesh.faces.push_back(corners);
    Geometry& geometry = mesh.scene.geometry;
    if (corners.size() > 3) return geometry.add(Polygon{corners}, 0);
    const auto first = static_cast<std::uint32_t>(geometry.vertices.size());
    geometry.vertices.insert(geometry.vertices.end(), corners.begin(), corners.end());
    geometry.add(Triangle{{first, first + 1, first + 2}}, 0);
}

}  // namespace

ClosedMesh uv_sphere(const std::string& name, const Vec3& centre, const Vec3& radius, Faces faces,
                     int rings) {
    ClosedMesh mesh{name, {}, centre, radius, {}};
    const Corners corners{centre, radius, rings};
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < 2 * rings; ++segment) {
            const Vec3 a = corners.at(ring, segment), b = corners.at(ring + 1, segment);
            const Vec3 c = corners.at(ring + 1, segment + 1), d = corners.at(ring, segment + 1);
            if (ring == 0) {
                add_face(mesh, {a, b, c});
            } else if (ring == rings - 1) {
                add_face(mesh, {a, b, d});
            } else if (faces == Faces::mixed && (ring + segment) % 2 == 0) {
                add_face(mesh, {a, b, c, d});
            } else {
                add_face(mesh, {a, b, c});
                add_face(mesh, {a, c, d});
            }
        }
    }
    return mesh;
}

}  // namespace etalon
