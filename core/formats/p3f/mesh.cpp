// mesh: vertices, then triangles of them.
#include <algorithm>
#include <array>

#include "core/formats/p3f/loader.h"

namespace etalon::p3f {
namespace {

/// Room for `extra` more elements, in steps that keep many small requests cheap.
template <class T>
void make_room(std::vector<T>& v, std::size_t extra) {
    const std::size_t needed = v.size() + extra;
    if (needed > v.capacity()) v.reserve(std::max(needed, 2 * v.capacity()));
}

/// The vertices of the mesh being read, in the scene's array.
struct Vertices {
    std::uint32_t first;
    std::int64_t count;
};

Vertices read_vertices(Loader& loader, std::size_t count) {
    std::vector<Vec3>& vertices = loader.scene.vertices;
    const std::size_t first = vertices.size();
    make_room(vertices, count);
    for (std::size_t i = 0; i < count && loader.in.ok(); ++i) {
        vertices.push_back(loader.in.vector("vertex"));
    }
    if (!loader.in.ok()) vertices.resize(first);
    return {static_cast<std::uint32_t>(first), static_cast<std::int64_t>(count)};
}

/// A vertex is named by its number from 1, or from the end by -1, -2, ... Says which is wrong.
bool read_face(Reader& in, const Vertices& vertices, std::array<std::uint32_t, 3>& corners) {
    bool good = true;
    for (std::uint32_t& corner : corners) {
        const std::size_t offset = in.tokens().offset();
        const std::int64_t number = in.integer("face");
        if (!in.ok()) return false;
        const std::int64_t index = number > 0 ? number - 1 : number + vertices.count;
        if (number != 0 && index >= 0 && index < vertices.count) {
            corner = vertices.first + static_cast<std::uint32_t>(index);
        } else {
            in.warn_at(offset, "face", "face left out: no vertex {} in a mesh of {} vertices",
                       number, vertices.count);
            good = false;
        }
    }
    return good;
}

bool is_line(const std::array<std::uint32_t, 3>& c) {
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

void read_faces(Loader& loader, const Vertices& vertices, std::size_t count) {
    Reader& in = loader.in;
    const std::size_t expected = std::min(count, in.room_for(3));
    make_room(loader.scene.all<Triangle>(), expected);
    make_room(loader.scene.primitives, expected);
    const std::uint32_t material = loader.current_material();
    const Sides sides = loader.sides();
    std::size_t lines = 0;
    for (std::size_t i = 0; i < count && in.ok(); ++i) {
        Triangle face{};
        if (!read_face(in, vertices, face.vertices)) continue;
        if (is_line(face.vertices)) {
            ++lines;
        } else {
            loader.scene.add(face, material, sides);
        }
    }
    if (lines > 0) in.warn("degenerate", "{} faces left out: they name a vertex twice", lines);
}

}  // namespace

/// A mesh that breaks off keeps the faces read so far.
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
