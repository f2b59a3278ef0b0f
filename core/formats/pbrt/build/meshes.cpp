#include "core/base/make_room.h"
#include "core/formats/pbrt/build/shape_builder.h"
#include "core/parallel/parallel.h"
#include "core/tessellate/grid_corners.h"
#include "core/tessellate/loop_subdivision.h"
#include "core/tessellate/nurbs.h"

namespace etalon::pbrt {
namespace {

Vec3f triple(std::span<const float> numbers, std::size_t i) {
    return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

/// Appends value(i) for each i below `count`, on all threads.
template <class Vector, class Value>
void append(Vector& to, std::size_t count, const Value& value) {
    constexpr std::size_t worth_a_thread = 1 << 14;
    const std::size_t first = to.size();
    make_room(to, count);
    to.resize(first + count);
    parallel_for(count, worth_a_thread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) to[first + i] = value(i);
    });
}

/// Adds the vertices of a mesh. Returns the number of the first.
std::uint32_t add_vertices(ShapeBuilder& s, const MeshData& mesh) {
    Geometry& g = s.geometry();
    const std::size_t count = mesh.points.size() / 3;
    const auto first = static_cast<std::uint32_t>(g.vertices.size());
    append(g.vertices, count, [&](std::size_t i) { return s.point(triple(mesh.points, i)); });
    // Their lengths count where they are interpolated.
    append(g.normals, mesh.normals.size() / 3,
           [&](std::size_t i) { return s.normal(Vec3(triple(mesh.normals, i))); });
    append(g.uvs, mesh.uvs.size() / 2, [&](std::size_t i) {
        return std::array{mesh.uvs[2 * i], mesh.uvs[2 * i + 1]};
    });
    return first;
}

void append_numbers(const std::vector<Vec3>& from, std::vector<float>& to) {
    to.reserve(3 * from.size());
    for (const Vec3& v : from) {
        for (const double x : {v.x, v.y, v.z}) to.push_back(static_cast<float>(x));
    }
}

using Corners = std::span<const std::uint32_t>;

/// Returns the vertex numbers in `indices`, or why they are invalid.
std::variant<Corners, std::string> corners(std::span<const std::int32_t> indices,
                                           std::size_t vertices) {
    const auto of_triangles = indices.first(indices.size() / 3 * 3);
    const auto is_bad = [&](std::int32_t index) {
        return static_cast<std::uint32_t>(index) >= vertices;  // as those below 0 are, too
    };
    const auto bad = std::ranges::find_if(of_triangles, is_bad);
    if (bad != of_triangles.end()) {
        return fmt::format("there is no vertex {}; its {} vertices are numbered from 0", *bad,
                           vertices);
    }
    // An integer may be looked at as the unsigned one of its size.
    return Corners(reinterpret_cast<const std::uint32_t*>(of_triangles.data()),
                   of_triangles.size());
}

/// A parametric direction of the shape "nurbs": 'u' or 'v'.
NurbsAxis nurbs_axis(const Parameters& p, char name) {
    const auto of = [name](std::string_view format) {
        return fmt::format(fmt::runtime(format), name);
    };
    const auto count = [&](const char* format) {
        return static_cast<std::size_t>(std::max(0, p.integer(of(format))));
    };
    NurbsAxis axis{count("n{}"), count("{}order"), p.numbers(of("{}knots")), 0, 0};
    const auto end = [&](const char* format, std::size_t knot) -> double {
        if (p.is_given(of(format))) return p.number(of(format));
        return knot < axis.knots.size() ? axis.knots[knot] : 0.0F;
    };
    axis.begin = end("{}0", axis.order - 1);
    axis.end = end("{}1", axis.points);
    return axis;
}

/// Returns the control points of the shape "nurbs": "P", or else "Pw".
std::vector<std::array<float, 4>> nurbs_points(const Parameters& p) {
    std::vector<std::array<float, 4>> points;
    const std::span<const float> flat = p.numbers("P"), weighted = p.numbers("Pw");
    for (std::size_t i = 0; i + 2 < flat.size(); i += 3) {
        points.push_back({flat[i], flat[i + 1], flat[i + 2], 1});
    }
    for (std::size_t i = 0; flat.empty() && i + 3 < weighted.size(); i += 4) {
        points.push_back({weighted[i], weighted[i + 1], weighted[i + 2], weighted[i + 3]});
    }
    return points;
}

}  // namespace

void build_mesh(ShapeBuilder& s, const MeshData& mesh) {
    Geometry& g = s.geometry();
    const bool has_normals = !mesh.normals.empty();
    const std::uint32_t first = add_vertices(s, mesh);
    SurfaceBinding binding;
    binding.corner_normals = has_normals;
    binding.flipped = has_normals ? mesh.flipped : s.flips_normals();
    if (!mesh.uvs.empty()) {
        binding.uv_offset = static_cast<std::uint32_t>(g.vertices.size() - g.uvs.size());
    }
    s.begin(binding);
    const std::uint32_t normal_offset = has_normals ? g.normal_offset() : no_index;
    std::size_t degenerate = 0;
    g.all<Triangle>().reserve(mesh.corners.size() / 3);
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
    if (s.parameters().is_given("S")) {
        s.b.warn(s.shape.plugin.where, "mesh",
                 "\"S\" left out: tangents follow the texture coordinates");
    }
    mesh.uvs = mesh.uvs.first(std::min(mesh.uvs.size(), 2 * vertices));
    const auto checked = corners(p.integers("indices"), vertices);
    if (const auto* why = std::get_if<std::string>(&checked)) return s.skip(*why);
    mesh.corners = std::get<0>(checked);
    mesh.flipped = s.shape.reverse_orientation;
    build_mesh(s, mesh);
}

void build_ply_mesh(ShapeBuilder& s) {
    PlyFile file = s.b.ply_files.take(s.shape);
    if (!file.error.empty()) return s.skip(fmt::format("{}: {}", file.path, file.error));
    s.b.log.append(file.said);
    if (!file.mesh) return s.skip(fmt::format("{} cannot be read", file.path));
    const PlyMesh& ply = *file.mesh;
    build_mesh(s, {ply.positions, ply.normals, ply.uvs, ply.indices, s.shape.reverse_orientation});
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

void build_heightfield(ShapeBuilder& s) {
    const Parameters& p = s.parameters();
    const std::span<const float> heights = p.numbers("Pz");
    const std::int64_t columns = p.integer("nu"), rows = p.integer("nv");
    if (columns < 2 || rows < 2) return s.skip("it has no area");
    if (columns * rows != static_cast<std::int64_t>(heights.size())) {
        return s.skip(fmt::format("{} x {} heights are {}, not {}", columns, rows, columns * rows,
                                  heights.size()));
    }
    std::vector<float> points, uvs;
    points.reserve(3 * heights.size());
    uvs.reserve(2 * heights.size());
    for (const float height : heights) {
        const auto number = static_cast<std::int64_t>(uvs.size() / 2);
        const std::int64_t column = number % columns, row = number / columns;
        const float x = static_cast<float>(column) / static_cast<float>(columns - 1),
                    y = static_cast<float>(row) / static_cast<float>(rows - 1);
        points.insert(points.end(), {x, y, height});
        uvs.insert(uvs.end(), {x, y});
    }
    const std::vector<std::uint32_t> cells =
        grid_corners(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows));
    build_mesh(s, {points, {}, uvs, cells});
}

void build_nurbs(ShapeBuilder& s) {
    constexpr std::uint32_t side = 30;  // pbrt-v3's
    const std::vector<std::array<float, 4>> points = nurbs_points(s.parameters());
    const Nurbs surface{nurbs_axis(s.parameters(), 'u'), nurbs_axis(s.parameters(), 'v'), points};
    const std::string error = nurbs_error(surface);
    if (!error.empty()) return s.skip(error);
    const NurbsGrid grid = diced(surface, side);
    std::vector<float> positions, normals;
    append_numbers(grid.points, positions);
    append_numbers(grid.normals, normals);
    if (!std::ranges::all_of(positions, [](float x) { return std::isfinite(x); })) {
        return s.skip("its weights or points are out of range");
    }
    const std::span<const float> uvs(grid.uvs.data()->data(), 2 * grid.uvs.size());
    const std::vector<std::uint32_t> cells = grid_corners(side, side);
    build_mesh(s, {positions, normals, uvs, cells, s.shape.reverse_orientation});
}

}  // namespace etalon::pbrt
