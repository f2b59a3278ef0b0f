#include "core/tessellate/loop_subdivision.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/tessellate/loop_rules.h"

namespace etalon {
namespace {

constexpr std::uint32_t none = HalfEdges::none;

/// Largest number of triangles: more would exceed most machines' memory, at some 100 bytes each.
constexpr std::size_t most_triangles = 50'000'000;

/// Returns the largest number of triangles made of `count`. A small file needs little memory: five
/// levels are allowed, and more as long as they make no more than a million.
std::size_t most_triangles_of(std::size_t count) {
    constexpr std::size_t million = 1 << 20, five_levels = 1 << 10;
    return std::min(std::max(million, five_levels * count), most_triangles);
}

std::size_t triangles_after(std::size_t count, int levels) {
    for (; levels > 0 && count <= most_triangles; --levels) count *= 4;
    return count;
}

/// Returns, for each vertex v, the side of its last triangle that starts from it.
std::vector<std::uint32_t> make_starts(const HalfEdges& sides, std::size_t vertex_count) {
    std::vector<std::uint32_t> starts(vertex_count, none);
    for (std::uint32_t side = 0; side < sides.origins.size(); ++side) {
        starts[sides.origins[side]] = side;
    }
    return starts;
}

/// Returns the number of a side of one of the four triangles into which `triangle` is split: those
/// at its corners 0, 1, 2 and the inner one, 3. A corner's triangle has that corner at the same
/// index; the inner one has the middle of side k at index k.
std::uint32_t side_of_part(std::uint32_t triangle, std::uint32_t part, std::uint32_t side) {
    return 3 * (4 * triangle + part) + side;
}

/// Return the part of a split side next to its start, and next to its end.
std::uint32_t first_half(std::uint32_t side) {
    return side_of_part(side / 3, side % 3, side % 3);
}
std::uint32_t second_half(std::uint32_t side) {
    return side_of_part(side / 3, HalfEdges::next(side) % 3, side % 3);
}

/// Appends the vertices that split the sides, and returns their numbers.
std::vector<std::uint32_t> split_sides(const LoopMesh& mesh, LoopMesh& finer) {
    const HalfEdges& sides = mesh.sides;
    std::vector<std::uint32_t> middles(sides.origins.size(), none);
    for (std::uint32_t side = 0; side < middles.size(); ++side) {
        if (middles[side] != none) continue;
        middles[side] = static_cast<std::uint32_t>(finer.positions.size());
        if (sides.twins[side] != none) middles[sides.twins[side]] = middles[side];
        finer.positions.push_back(odd_position(mesh, side));
        finer.starts.push_back(side_of_part(side / 3, 3, side % 3));
    }
    return middles;
}

void move_vertices(const LoopMesh& mesh, LoopMesh& finer) {
    Ring ring;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const std::uint32_t start = mesh.starts[v];
        if (start != none) ring.gather(mesh, v);
        finer.positions.push_back(start == none ? mesh.positions[v]
                                                : even_position(mesh.positions[v], ring));
        finer.starts.push_back(start == none ? none : first_half(start));
    }
}

/// Sets the vertices and the twins of the four triangles beside the middle of `side`.
void connect_side(const HalfEdges& sides, std::uint32_t side, std::uint32_t middle,
                  HalfEdges& finer) {
    const std::uint32_t inner = side_of_part(side / 3, 3, side % 3);
    const std::uint32_t corner = first_half(side), behind = second_half(side);
    finer.origins[corner] = sides.origins[side];
    finer.origins[HalfEdges::next(corner)] = middle;
    finer.origins[behind] = middle;
    finer.origins[inner] = middle;
    // The inner triangle's side from here leads to the middle of the next side: it cuts off the
    // corner between them.
    const std::uint32_t across = HalfEdges::next(HalfEdges::next(behind));
    finer.twins[inner] = across;
    finer.twins[across] = inner;
    const std::uint32_t twin = sides.twins[side];
    finer.twins[corner] = twin == none ? none : second_half(twin);
    finer.twins[behind] = twin == none ? none : first_half(twin);
}

LoopMesh refined(const LoopMesh& mesh) {
    LoopMesh finer;
    move_vertices(mesh, finer);
    const std::vector<std::uint32_t> middles = split_sides(mesh, finer);
    finer.sides.origins.resize(4 * middles.size());
    finer.sides.twins.resize(4 * middles.size());
    for (std::uint32_t side = 0; side < middles.size(); ++side) {
        connect_side(mesh.sides, side, middles[side], finer.sides);
    }
    return finer;
}

/// Calls f(vertex, ring) for each vertex that triangles use.
template <class F>
void for_each_ring(const LoopMesh& mesh, const F& f) {
    Ring ring;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        if (mesh.starts[v] == none) continue;
        ring.gather(mesh, v);
        f(v, ring);
    }
}

SmoothMesh on_surface(LoopMesh mesh) {
    std::vector<Vec3> positions = mesh.positions;
    for_each_ring(mesh, [&](std::uint32_t v, const Ring& ring) {
        positions[v] = limit_position(mesh.positions[v], ring);
    });
    mesh.positions = std::move(positions);
    std::vector<Vec3> normals(mesh.positions.size(), Vec3(0));
    for_each_ring(mesh, [&](std::uint32_t v, const Ring& ring) {
        normals[v] = limit_normal(mesh.positions[v], ring);
    });
    return {std::move(mesh.positions), std::move(normals), std::move(mesh.sides.origins)};
}

}  // namespace

Result<SmoothMesh> loop_subdivision(std::span<const Vec3> points,
                                    std::span<const std::uint32_t> corners, int levels) {
    Result<HalfEdges> sides = make_half_edges(corners, points.size());
    if (!sides) return {{}, sides.error};
    const std::size_t count = corners.size() / 3, most = most_triangles_of(count);
    if (triangles_after(count, levels) > most) {
        return {{},
                fmt::format("{} levels make more than {} triangles of {}", levels, most, count)};
    }
    if (corners.empty()) levels = 0;
    LoopMesh mesh{std::move(sides.value), {points.begin(), points.end()}, {}};
    mesh.starts = make_starts(mesh.sides, points.size());
    for (int level = 0; level < levels; ++level) mesh = refined(mesh);
    return {on_surface(std::move(mesh)), {}};
}

}  // namespace etalon
