// mesh: vertices, then the triangles between them.
#include <algorithm>
#include <array>

#include "core/base/make_room.h"
#include "core/formats/p3f/p3f_loader.h"

namespace etalon::p3f {
namespace {

/// Numbers of the current mesh's vertices in the scene.
using Vertices = std::vector<std::uint32_t>;

template <class Vector>
void keep_first(Vector& v, std::size_t count) {
    v.erase(v.begin() + static_cast<std::ptrdiff_t>(count), v.end());
}

Vertices read_vertices(Loader& loader, std::size_t count) {
    Geometry& geometry = loader.scene.geometry;
    const std::size_t before = geometry.vertices.size();
    const std::size_t decimal_before = geometry.decimal_vertices.size();
    make_room(geometry.decimal_vertices, count);
    Vertices numbers;
    numbers.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 position = loader.in.vector("vertex");
        if (!loader.in.ok()) break;
        numbers.push_back(geometry.add_compact_vertex(position));
    }
    if (loader.in.ok()) return numbers;
    keep_first(geometry.vertices, before);
    keep_first(geometry.decimal_vertices, decimal_before);
    return {};
}

/// Reads the number of a vertex, from 1, or from the end by -1, -2, ... Reports a wrong one.
bool read_face(Reader& in, const Vertices& vertices, TriangleIndices& corners) {
    bool good = true;
    for (std::uint32_t& corner : corners) {
        const std::size_t offset = in.tokens().offset();
        const std::int64_t number = in.integer("face");
        if (!in.ok()) return false;
        const auto count = static_cast<std::int64_t>(vertices.size());
        const std::int64_t index = number > 0 ? number - 1 : number + count;
        if (number != 0 && index >= 0 && index < count) {
            corner = vertices[static_cast<std::size_t>(index)];
        } else {
            in.warn_at(offset, "face", "face left out: no vertex {} in a mesh of {} vertices",
                       number, count);
            good = false;
        }
    }
    return good;
}

bool is_line(const TriangleIndices& c) {
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

void read_faces(Loader& loader, const Vertices& vertices, std::size_t count) {
    Reader& in = loader.in;
    loader.scene.geometry.all<Triangle>().reserve(std::min(count, in.room_for(3)));
    const std::uint32_t material = loader.current_material();
    const Sides sides = loader.sides();
    std::size_t lines = 0;
    for (std::size_t i = 0; i < count && in.ok(); ++i) {
        Triangle face{};
        if (!read_face(in, vertices, face.vertices)) continue;
        if (is_line(face.vertices)) {
            ++lines;
        } else {
            loader.scene.geometry.add(face, material, sides);
        }
    }
    if (lines > 0) in.warn("degenerate", "{} faces left out: they name a vertex twice", lines);
}

}  // namespace

/// A mesh that ends early keeps the faces read so far.
void read_mesh(Loader& loader) {
    Reader& in = loader.in;
    const std::size_t vertex_count = in.count("number of vertices", 3);
    const std::size_t offset = in.tokens().offset();
    const std::int64_t face_count = in.integer("number of faces");
    if (!in.ok()) return;
    if (face_count < 0) {
        return in.fail_at(offset, "count", "the number of faces of 'mesh' is negative");
    }
    const Vertices vertices = read_vertices(loader, vertex_count);
    if (in.ok()) read_faces(loader, vertices, static_cast<std::size_t>(face_count));
}

}  // namespace etalon::p3f
