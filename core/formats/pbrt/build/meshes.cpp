#include "core/formats/file_text.h"
#include "core/formats/pbrt/build/shape_builder.h"
#include "core/formats/ply/ply.h"
#include "core/tessellate/loop_subdivision.h"

namespace etalon::pbrt {
namespace {

Vec3f triple(std::span<const float> numbers, std::size_t i) {
    return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

/// Adds the vertices of a mesh. Returns the number of the first.
std::uint32_t add_vertices(ShapeBuilder& s, const MeshData& mesh) {
    Geometry& g = s.geometry();
    const auto first = static_cast<std::uint32_t>(g.vertices.size());
    for (std::size_t i = 0; i < mesh.points.size() / 3; ++i) {
        const Vec3 position = s.point(triple(mesh.points, i));
        if (mesh.normals.empty()) {
            g.add_vertex(position);
        } else {
            g.add_vertex(position, s.normal(Vec3(triple(mesh.normals, i))).normalized());
        }
    }
    for (std::size_t i = 0; i + 1 < mesh.uvs.size(); i += 2) {
        s.b.look().uvs.push_back({mesh.uvs[i], mesh.uvs[i + 1]});
    }
    return first;
}

void append_numbers(const std::vector<Vec3>& from, std::vector<float>& to) {
    to.reserve(3 * from.size());
    for (const Vec3& v : from) {
        for (const double x : {v.x, v.y, v.z}) to.push_back(static_cast<float>(x));
    }
}

/// The numbers of vertices in `indices`, or why they are none.
std::variant<std::vector<std::uint32_t>, std::string> corners(std::span<const std::int32_t> indices,
                                                              std::size_t vertices) {
    std::vector<std::uint32_t> result;
    result.reserve(indices.size());
    for (const std::int32_t index : indices.first(indices.size() / 3 * 3)) {
        if (index < 0 || static_cast<std::size_t>(index) >= vertices) {
            return fmt::format("there is no vertex {}; its {} vertices are numbered from 0", index,
                               vertices);
        }
        result.push_back(static_cast<std::uint32_t>(index));
    }
    return result;
}

}  // namespace

void build_mesh(ShapeBuilder& s, const MeshData& mesh) {
    Geometry& g = s.geometry();
    const bool has_normals = !mesh.normals.empty();
    const std::uint32_t first = add_vertices(s, mesh);
    SurfaceBinding binding;
    binding.corner_normals = has_normals;
    binding.flipped = has_normals ? mesh.flipped : s.flips_winding();
    if (!mesh.uvs.empty()) {
        binding.uv_offset = static_cast<std::uint32_t>(g.vertices.size() - s.b.look().uvs.size());
    }
    s.begin(binding);
    const std::uint32_t normal_offset = has_normals ? g.normal_offset() : no_index;
    std::size_t degenerate = 0;
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
        const TriangleIndices t{first + mesh.corners[i], first + mesh.corners[i + 1],
                                first + mesh.corners[i + 2]};
        const Vec3 a = g.vertex(t[0]), normal = (g.vertex(t[1]) - a).cross(g.vertex(t[2]) - a);
        if (!etalon::is_finite(normal) || normal == Vec3(0)) {
            ++degenerate;
            continue;
        }
        s.add(Triangle{t, normal_offset});
    }
    if (degenerate > 0) {
        s.b.warn(s.shape.plugin.where, "degenerate", "{} triangles without area left out of \"{}\"",
                 degenerate, s.shape.plugin.type->name);
    }
}

void build_triangle_mesh(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    MeshData mesh{p.numbers("P"), p.numbers("N"), p.numbers("uv")};
    const std::size_t vertices = mesh.points.size() / 3;
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.points.size()) {
        s.b.warn(s.shape.plugin.where, "mesh", "\"N\" left out: {} normals for {} vertices",
                 mesh.normals.size() / 3, vertices);
        mesh.normals = {};
    }
    if (!mesh.uvs.empty() && mesh.uvs.size() / 2 < vertices) {
        s.b.warn(s.shape.plugin.where, "mesh", "\"uv\" left out: {} coordinates for {} vertices",
                 mesh.uvs.size() / 2, vertices);
        mesh.uvs = {};
    }
    mesh.uvs = mesh.uvs.first(std::min(mesh.uvs.size(), 2 * vertices));
    auto checked = corners(p.integers("indices"), vertices);
    if (const auto* why = std::get_if<std::string>(&checked)) return s.skip(*why);
    mesh.corners = std::get<0>(checked);
    mesh.flipped = s.shape.reverse_orientation;
    build_mesh(s, mesh);
}

void build_ply_mesh(ShapeBuilder& s) {
    const std::string path(s.parameters().string("filename"));
    const FileText file = read_file(path);
    if (!file.error.empty()) return s.skip(fmt::format("{}: {}", path, file.error));
    DiagnosticLog log(path, file.text(), s.b.strict);
    const std::optional<PlyMesh> ply = read_ply(file.text(), log);
    s.b.log.append(log.list());
    if (!ply) return s.skip(fmt::format("{} cannot be read", path));
    build_mesh(s,
               {ply->positions, ply->normals, ply->uvs, ply->indices, s.shape.reverse_orientation});
}

void build_loop_subdivision(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < p.numbers("P").size() / 3; ++i) {
        points.emplace_back(triple(p.numbers("P"), i));
    }
    const auto checked = corners(p.integers("indices"), points.size());
    if (const auto* why = std::get_if<std::string>(&checked)) return s.skip(*why);
    const Result<SmoothMesh> smooth =
        loop_subdivision(points, std::get<0>(checked), std::max(0, p.integer("levels")));
    if (!smooth) return s.skip(smooth.error);
    std::vector<float> positions, normals;
    append_numbers(smooth.value.points, positions);
    append_numbers(smooth.value.normals, normals);
    build_mesh(s, {positions, normals, {}, smooth.value.corners, s.shape.reverse_orientation});
}

}  // namespace etalon::pbrt
