#include "core/formats/obj.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/formats/reader.h"
#include "core/formats/triangulation.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

using Corner = ObjMesh::Corner;

/// Returns the number of characters of the line end at an offset.
std::size_t line_end_size(std::string_view text, std::size_t at) {
    const std::string_view rest = text.substr(at, 2);
    if (rest == "\r\n") return 2;
    return rest.starts_with('\n') || rest.starts_with('\r') ? 1 : 0;
}

bool is_in_comment(std::string_view text, std::size_t at) {
    const std::size_t start = text.substr(0, at).find_last_of("\r\n") + 1;  // npos + 1 is 0
    return text.substr(start, at - start).find('#') != text.npos;
}

/// Returns the text with blanks in place of the backslashes that continue a line on the next, and
/// of these lines' ends, so that offsets stay; nothing if there are none.
std::optional<std::string> with_joined_lines(std::string_view text) {
    std::optional<std::string> joined;
    for (std::size_t at = text.find('\\'); at != text.npos; at = text.find('\\', at + 1)) {
        const std::size_t size = line_end_size(text, at + 1);
        if (size == 0 || is_in_comment(text, at)) continue;
        if (!joined) joined = text;
        joined->replace(at, 1 + size, 1 + size, ' ');
    }
    return joined;
}

template <class F>
void for_each_line(std::string_view text, DiagnosticLog& log, F&& read) {
    Tokenizer lines(text);
    while (!lines.at_end()) {
        Reader in(lines.take_line(), log);
        in.begin();
        read(in);
    }
}

/// Reads a point. A bad one still counts, so that later numbers stay right.
Vec3 read_point(Reader& in, std::string_view what) {
    const Vec3 p = in.vector(what);
    return in.ok() ? p : Vec3(nan_value);
}

/// Reads the numbers at a corner of a face, 0 for an omitted one: "7", "7/2", "7//3" or "7/2/3".
struct Numbers {
    std::int64_t vertex = 0, texture = 0, normal = 0;
};

std::optional<Numbers> numbers_of(std::string_view word) {
    Numbers n;
    const char* p = word.data();
    const char* const last = p + word.size();
    for (std::int64_t* const number : {&n.vertex, &n.texture, &n.normal}) {
        const bool left_out = number != &n.vertex && (p == last || *p == '/');
        if (!left_out) {
            const ScannedNumber scanned = scan_number(p, last, *number);
            if (scanned.status != NumberStatus::ok) return std::nullopt;
            p = scanned.end;
        }
        if (p == last) return n;
        if (*p++ != '/') break;
    }
    return std::nullopt;
}

/// Reads the faces of a file whose vertices and normals are known.
class FaceReader {
  public:
    explicit FaceReader(ObjMesh& mesh) : mesh_(mesh) {}

    void read_line(Reader& in) {
        if (in.keyword() == "v") ++vertices_so_far_;
        if (in.keyword() == "vn") ++normals_so_far_;
        if (in.keyword() == "f") read_face(in);
    }

  private:
    void read_face(Reader& in) {
        corners_.clear();
        while (in.ok() && !in.tokens().at_end()) read_corner(in);
        if (!in.ok()) return;
        if (corners_.size() < 3) {
            return in.warn("face", "face left out: {} corners, expected at least 3",
                           corners_.size());
        }
        std::vector<Vec3> points;
        for (const Corner& c : corners_) points.push_back(mesh_.vertices[c.vertex]);
        for (const auto& [a, b, c] : triangulate(points)) {
            add(corners_[a], corners_[b], corners_[c]);
        }
    }

    void read_corner(Reader& in) {
        const std::size_t offset = in.tokens().offset();
        const std::string_view word = in.tokens().next();
        const std::optional<Numbers> n = numbers_of(word);
        if (!n) {
            return in.fail_at(offset, "face",
                              "face left out: expected v, v/t, v//n or v/t/n, found {}",
                              in_quotes(word));
        }
        const std::uint32_t vertex = index_of(n->vertex, vertices_so_far_, mesh_.vertices.size());
        const std::uint32_t normal = index_of(n->normal, normals_so_far_, mesh_.normals.size());
        if (vertex == no_index) {
            in.fail_at(offset, "face", "face left out: no vertex {} in a mesh of {} vertices",
                       n->vertex, mesh_.vertices.size());
        } else if (normal == no_index && n->normal != 0) {
            in.fail_at(offset, "face", "face left out: no normal {} in a mesh of {} normals",
                       n->normal, mesh_.normals.size());
        } else if (!is_finite(mesh_.vertices[vertex])) {
            in.fail_at(offset, "face", "face left out: its vertex {} could not be read", n->vertex);
        }
        corners_.push_back({vertex, normal});
    }

    static std::uint32_t index_of(std::int64_t number, std::int64_t so_far, std::size_t count) {
        const std::int64_t index = number > 0 ? number - 1 : so_far + number;
        const bool exists = number != 0 && index >= 0 && index < static_cast<std::int64_t>(count);
        return exists ? static_cast<std::uint32_t>(index) : no_index;
    }

    /// Adds a triangle, unless it is degenerate, as pieces of polygons that repeat a vertex are.
    void add(const Corner& a, const Corner& b, const Corner& c) {
        if (a.vertex == b.vertex || b.vertex == c.vertex || c.vertex == a.vertex) return;
        mesh_.triangles.push_back({a, b, c});
    }

    ObjMesh& mesh_;
    std::int64_t vertices_so_far_ = 0, normals_so_far_ = 0;
    std::vector<Corner> corners_;  // of the face being read
};

bool is_direction(const Vec3& v) {
    return is_finite(v) && v != Vec3(0);
}

/// Returns the unit normal at each vertex: the sum of its faces' normals, weighted by their areas.
std::vector<Vec3> vertex_normals(const ObjMesh& mesh) {
    Box3 box;
    for (const Vec3& v : mesh.vertices) {
        if (is_finite(v)) box.extendBy(v);
    }
    const double scale = power_of_two_reciprocal(max_abs(box.size()));
    std::vector<Vec3> sums(mesh.vertices.size(), Vec3(0));
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3& p = mesh.vertices[a.vertex];
        const Vec3 edge1 = (mesh.vertices[b.vertex] - p) * scale;
        const Vec3 edge2 = (mesh.vertices[c.vertex] - p) * scale;
        for (const Corner& corner : {a, b, c}) sums[corner.vertex] += edge1.cross(edge2);
    }
    for (Vec3& n : sums) {
        n = to_unit_magnitude(n);
        if (n != Vec3(0)) n = normalized(n);
    }
    return sums;
}

}  // namespace

ObjMesh read_obj(std::string_view text, DiagnosticLog& log) {
    ObjMesh mesh;
    const std::optional<std::string> joined = with_joined_lines(text);
    if (joined) text = *joined;
    for_each_line(text, log, [&](Reader& in) {
        if (in.keyword() == "v") mesh.vertices.push_back(read_point(in, "position"));
        if (in.keyword() == "vn") mesh.normals.push_back(read_point(in, "normal"));
    });
    FaceReader faces(mesh);  // in a second pass, as a face may name vertices that follow it
    for_each_line(text, log, [&](Reader& in) { faces.read_line(in); });
    return mesh;
}

void complete_normals(ObjMesh& mesh) {
    const auto names_none = [](const auto& triangle) {
        return std::ranges::all_of(triangle, [](const Corner& c) { return c.normal == no_index; });
    };
    const bool by_order = std::ranges::all_of(mesh.triangles, names_none);
    const std::size_t given = mesh.normals.size();
    const std::vector<Vec3> means = vertex_normals(mesh);
    mesh.normals.insert(mesh.normals.end(), means.begin(), means.end());
    for (auto& triangle : mesh.triangles) {
        for (Corner& c : triangle) {
            if (by_order && c.vertex < given) c.normal = c.vertex;
            const bool good = c.normal != no_index && is_direction(mesh.normals[c.normal]);
            if (!good) c.normal = static_cast<std::uint32_t>(given) + c.vertex;
        }
    }
}

}  // namespace etalon
