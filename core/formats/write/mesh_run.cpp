#include "core/formats/write/mesh_run.h"

#include <unordered_map>

namespace etalon {
namespace {

bool is_smooth(const Triangle& t) {
    return t.normal_offset != no_index;
}

std::vector<Triangle> run_from(const Geometry& geometry, std::size_t first) {
    const Primitive start = geometry.primitives[first];
    const bool smooth = is_smooth(geometry.get<Triangle>(start));
    std::vector<Triangle> run;
    for (std::size_t i = first; i < geometry.primitives.size(); ++i) {
        const Primitive p = geometry.primitives[i];
        const bool alike = p.kind == start.kind && p.material == start.material &&
                           p.sides == start.sides && is_smooth(geometry.get<Triangle>(p)) == smooth;
        if (!alike) break;
        run.push_back(geometry.get<Triangle>(p));
    }
    return run;
}

/// Returns a mesh of only the vertices that are used, in the order of the triangles, so that the
/// mesh is written unchanged once it has been read back.
MeshRun flat_mesh(const Geometry& geometry, const std::vector<Triangle>& run) {
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;  // in the mesh
    MeshRun mesh;
    for (const Triangle& t : run) {
        auto& face = mesh.faces.emplace_back(t.vertices);
        for (std::uint32_t& v : face) {
            const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
            const auto [known, is_new] = numbers.try_emplace(v, next);
            if (is_new) mesh.vertices.push_back(geometry.vertex(v));
            v = known->second;
        }
    }
    return mesh;
}

/// Makes a mesh with separate vertices for each corner, as the corners have separate normals.
MeshRun smooth_mesh(const Geometry& geometry, const std::vector<Triangle>& run) {
    MeshRun mesh;
    for (const Triangle& t : run) {
        const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.faces.push_back({v, v + 1, v + 2});
        for (std::uint32_t k = 0; k < 3; ++k) {
            mesh.vertices.push_back(geometry.vertex(t.vertices[k]));
            mesh.normals.push_back(geometry.normals[Geometry::normal_number(t, k)]);
        }
    }
    return mesh;
}

}  // namespace

MeshRun mesh_from(const Geometry& geometry, std::size_t first) {
    const std::vector<Triangle> run = run_from(geometry, first);
    return is_smooth(run.front()) ? smooth_mesh(geometry, run) : flat_mesh(geometry, run);
}

}  // namespace etalon
