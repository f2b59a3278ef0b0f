#include "core/formats/ply/ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "core/formats/ply/ply_faces.h"
#include "core/formats/ply/ply_vertices.h"

namespace etalon {
namespace ply {
namespace {

/// Returns whether a file has what a mesh needs. Reports what is missing.
bool is_mesh(const Header& header, DiagnosticLog& log) {
    const auto fail = [&](std::size_t offset, std::string_view message) {
        log.error(offset, "mesh", "{}", message);
        return false;
    };
    const Element *vertices = header.find("vertex"), *faces = header.find("face");
    if (!vertices || !faces) return fail(0, "a mesh needs elements 'vertex' and 'face'");
    if (vertices->count == 0) return fail(vertices->offset, "there are no vertices");
    if (faces->count == 0) return fail(faces->offset, "there are no faces");
    if (vertices->count > 0x7FFFFFFF) return fail(vertices->offset, "there are too many vertices");
    for (const std::string_view name : {"x", "y", "z"}) {
        if (!vertices->find(name, false)) {
            return fail(vertices->offset, "the vertices have no x, y and z");
        }
    }
    return corners_of(*faces) || fail(faces->offset, "the faces have no list 'vertex_indices'");
}

template <class Source>
class MeshReader {
  public:
    MeshReader(const Header& header, Source in, DiagnosticLog& log)
        : header_(header), in_(in), log_(log) {}

    std::optional<PlyMesh> read() {
        for (const Element& element : header_.elements) {
            if (in_.room_for(element) < element.count) {
                log_.error(
                    element.offset, "count",
                    "{} elements {} are announced, but the rest of the file holds at most {}",
                    element.count, in_quotes(element.name), in_.room_for(element));
                return std::nullopt;
            }
            if (!read_element(element)) {
                log_.error(in_.offset(), "syntax", "{} amid the elements {}", in_.error(),
                           in_quotes(element.name));
                return std::nullopt;
            }
        }
        return std::move(mesh_);
    }

  private:
    bool read_element(const Element& element) {
        if (&element == header_.find("vertex")) {
            return read_elements(in_, element, make_columns(element, mesh_));
        }
        if (&element == header_.find("face")) return read_faces(element);
        return read_elements(in_, element, std::vector<Column>(element.properties.size()));
    }

    bool read_faces(const Element& faces) {
        FaceReader<Source> reader(in_, faces, mesh_);
        if (!reader.read()) return false;
        if (reader.left_out() > 0) {
            log_.warn(faces.offset, "face",
                      "{} faces left out: only those of 3 and 4 corners are supported",
                      reader.left_out());
        }
        return true;
    }

    const Header& header_;
    Source in_;
    DiagnosticLog& log_;
    PlyMesh mesh_;
};

template <class Source>
std::optional<PlyMesh> read_body(const Header& header, std::string_view bytes, DiagnosticLog& log) {
    return MeshReader<Source>(header, Source(bytes, header.size), log).read();
}

std::optional<PlyMesh> read_body(const Header& header, std::string_view bytes, DiagnosticLog& log) {
    if (header.format == FileFormat::ascii) return read_body<AsciiNumbers>(header, bytes, log);
    const bool is_native = (header.format == FileFormat::little_endian) ==
                           (std::endian::native == std::endian::little);
    return is_native ? read_body<BinaryNumbers<ByteOrder::native>>(header, bytes, log)
                     : read_body<BinaryNumbers<ByteOrder::reversed>>(header, bytes, log);
}

constexpr std::uint32_t top_bit = 0x80000000;

bool all_finite(std::span<const float> values) {
    constexpr std::uint32_t exponent = 0x7F800000, lowest = 0x00800000;
    std::uint32_t carried = 0;  // no branch, so that the loop is vectorized
    for (const float f : values) carried |= (std::bit_cast<std::uint32_t>(f) & exponent) + lowest;
    return (carried & top_bit) == 0;
}

/// Returns whether all are less than `end`, whose top bit must not be set.
bool all_less(std::span<const std::uint32_t> values, std::uint32_t end) {
    std::uint32_t borrowed = 0;
    for (const std::uint32_t v : values) borrowed |= v | (end - 1 - v);
    return (borrowed & top_bit) == 0;
}

/// Sets values that are not finite to zero.
void clean(FilledLater<float>& values, std::string_view what, DiagnosticLog& log) {
    if (all_finite(values)) return;
    const auto is_bad = [](float f) { return !std::isfinite(f); };
    const auto count = std::ranges::count_if(values, is_bad);
    std::ranges::replace_if(values, is_bad, 0.0F);
    log.warn(DiagnosticLog::whole_file, "range", "{} numbers of the {} are not finite: taken as 0",
             count, what);
}

/// Leaves out the triangles with vertices that are not finite.
void drop_infinite_triangles(PlyMesh& mesh, DiagnosticLog& log) {
    if (all_finite(mesh.positions)) return;
    const auto is_good = [&](std::size_t v) { return all_finite({&mesh.positions[3 * v], 3}); };
    std::size_t kept = 0;
    const std::size_t count = mesh.indices.size() / 3;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t* const t = &mesh.indices[3 * i];
        if (!is_good(t[0]) || !is_good(t[1]) || !is_good(t[2])) continue;
        std::copy_n(t, 3, &mesh.indices[3 * kept]);
        if (!mesh.face_numbers.empty()) mesh.face_numbers[kept] = mesh.face_numbers[i];
        ++kept;
    }
    mesh.indices.resize(3 * kept);
    if (!mesh.face_numbers.empty()) mesh.face_numbers.resize(kept);
    if (kept < count) {
        log.warn(DiagnosticLog::whole_file, "range",
                 "{} triangles left out: a corner of them is not finite", count - kept);
    }
}

/// Returns whether all vertices of the faces exist. Reports the first that does not.
bool is_consistent(const PlyMesh& mesh, DiagnosticLog& log) {
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    if (all_less(mesh.indices, vertices)) return true;
    const auto bad = std::ranges::find_if(mesh.indices, [&](auto v) { return v >= vertices; });
    log.error(DiagnosticLog::whole_file, "face",
              "triangle {} names a vertex that is not among the {} of the mesh",
              (bad - mesh.indices.begin()) / 3 + 1, vertices);
    return false;
}

}  // namespace
}  // namespace ply

std::optional<PlyMesh> read_ply(std::string_view bytes, DiagnosticLog& log) {
    const std::optional<ply::Header> header = ply::read_header(bytes, log);
    if (!header || !ply::is_mesh(*header, log)) return std::nullopt;
    std::optional<PlyMesh> mesh = ply::read_body(*header, bytes, log);
    if (!mesh || !ply::is_consistent(*mesh, log)) return std::nullopt;
    ply::drop_infinite_triangles(*mesh, log);
    ply::clean(mesh->normals, "normals", log);
    ply::clean(mesh->uvs, "texture coordinates", log);
    return mesh;
}

}  // namespace etalon
