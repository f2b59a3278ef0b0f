// triangle, object_flat and object_phong.
#include <cmath>
#include <filesystem>

#include "core/formats/file_text.h"
#include "core/formats/polygon_normal.h"
#include "core/formats/sce/sce_loader.h"
#include "core/numerics/transforms.h"

namespace etalon::sce {
namespace {

/// Reads the mesh of a file.
MeshFile read_mesh(Loader& loader, const std::string& path) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) return {{}, "there is no such file"};
    const FileText file = read_file(path, FileKind::regular);
    if (!file.error.empty()) return {{}, "it " + file.error};
    DiagnosticLog log(path, file.text(), loader.options.strict);
    MeshFile result{read_obj(file.text(), log), {}};
    loader.log.append(log);
    if (result.mesh.triangles.empty()) return {{}, "it holds no faces"};
    complete_normals(result.mesh);
    return result;
}

/// Returns the mesh of the file that the statement names, relative to the scene. Null, and a
/// warning, if there is none.
const ObjMesh* find_mesh(Loader& loader, Reader& in) {
    const std::size_t offset = in.tokens().offset();
    const std::string_view name = in.word("file");
    const std::string path = (loader.directory / name).string();
    if (const std::string error = loader.scope.check(path); !error.empty()) {
        loader.log.error(offset, "root", "{}", error);
        return nullptr;
    }
    auto place = loader.meshes.find(path);
    if (place == loader.meshes.end()) {
        place = loader.meshes.emplace(path, read_mesh(loader, path)).first;
    }
    const auto& [mesh, why] = place->second;
    if (why.empty()) return &mesh;
    in.warn_at(offset, "mesh", "'{}' of {} left out: {}", in.keyword(), in_quotes(name), why);
    return nullptr;
}

/// Returns whether vertex numbers of 31 bits suffice for the mesh.
bool fits(const Geometry& geometry, const ObjMesh& mesh) {
    return geometry.vertices.size() + mesh.vertices.size() + 3 * mesh.triangles.size() <
           decimal_vertex;
}

/// Returns the corners' normals, scaled so that the longest is a unit vector: only the ratios of
/// lengths matter, and normals of equal length stay so. Nothing if one has overflowed.
std::optional<std::array<Vec3, 3>> corner_normals(const ObjMesh& mesh, const NormalMap& to_world,
                                                  const std::array<ObjMesh::Corner, 3>& corners) {
    std::array<Vec3, 3> normals;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& n = normals[k] = to_world(mesh.normals[corners[k].normal]);
        longest = std::max(longest, is_finite(n) ? std::hypot(n.x, n.y, n.z) : infinity);
    }
    if (longest == 0 || longest == infinity) return std::nullopt;
    for (Vec3& n : normals) n = n / longest;
    return normals;
}

using Order = std::array<ObjMesh::Corner, 3>;

/// Returns the order of a face's corners in the world. A mirroring map reverses it, so that the
/// front stays the front.
Order world_order(const Order& face, bool mirrored) {
    return mirrored ? Order{face[0], face[2], face[1]} : face;
}

void add_flat_faces(Loader& loader, const ObjMesh& mesh, const std::vector<Vec3>& world) {
    LargeVector<Vec3>& vertices = loader.scene.geometry.vertices;
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), world.begin(), world.end());
    const bool mirrored = mirrors(loader.state.matrix);
    for (const Order& face : mesh.triangles) {
        const auto [a, b, c] = world_order(face, mirrored);
        loader.add(Triangle{{first + a.vertex, first + b.vertex, first + c.vertex}});
    }
}

void add_smooth_faces(Loader& loader, const ObjMesh& mesh, const std::vector<Vec3>& world) {
    Geometry& geometry = loader.scene.geometry;
    const bool mirrored = mirrors(loader.state.matrix);
    const NormalMap normal_map(loader.state.matrix);
    for (const Order& face : mesh.triangles) {
        const Order order = world_order(face, mirrored);
        const auto normals = corner_normals(mesh, normal_map, order);
        Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& position = world[order[k].vertex];
            triangle.vertices[k] =
                normals ? loader.smooth_vertices.number(geometry, position, (*normals)[k])
                        : geometry.add_vertex(position);
        }
        if (normals) triangle.normal_offset = geometry.normal_offset();
        loader.add(triangle);
    }
}

void read_object(Loader& loader, Reader& in, bool smooth) {
    const ObjMesh* const mesh = find_mesh(loader, in);
    if (!mesh || !loader.has_usable_matrix(in)) return;
    if (!fits(loader.scene.geometry, *mesh)) {
        return in.warn("mesh", "'{}' left out: too many vertices in all", in.keyword());
    }
    std::vector<Vec3> world;
    for (const Vec3& v : mesh->vertices) {
        world.push_back(loader.state.matrix.point(is_finite(v) ? v : Vec3(0)));
        if (is_finite(world.back())) continue;
        return in.warn("matrix", "'{}' left out: its position is not finite", in.keyword());
    }
    smooth ? add_smooth_faces(loader, *mesh, world) : add_flat_faces(loader, *mesh, world);
}

}  // namespace

void read_triangle(Loader& loader, Reader& in) {
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) corner = loader.state.matrix.point(in.vector("corner"));
    if (!in.ok() || !loader.has_usable_matrix(in)) return;
    const Vec3 normal = area_normal(corners);
    if (!is_finite(normal) || normal == Vec3(0)) {
        return in.warn("degenerate", "'triangle' left out: it has no area");
    }
    if (mirrors(loader.state.matrix)) std::swap(corners[1], corners[2]);
    Geometry& geometry = loader.scene.geometry;
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) triangle.vertices[k] = geometry.add_vertex(corners[k]);
    loader.add(triangle);
}

void read_flat_object(Loader& loader, Reader& in) {
    read_object(loader, in, false);
}

void read_smooth_object(Loader& loader, Reader& in) {
    read_object(loader, in, true);
}

}  // namespace etalon::sce
