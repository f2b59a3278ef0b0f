// The faces of a PLY file, as triangles.
#pragma once

#include "core/formats/ply/ply.h"
#include "core/formats/ply/ply_vertices.h"

namespace etalon::ply {

/// Returns the list of a face's vertices; nothing if there is none.
inline const Property* corners_of(const Element& faces) {
    const Property* const list = faces.find("vertex_indices", true);
    return list ? list : faces.find("vertex_index", true);
}

template <class Source>
class FaceReader {
  public:
    /// The element must have corners.
    FaceReader(Source& in, const Element& faces, PlyMesh& mesh)
        : in_(in), faces_(faces), corners_(*corners_of(faces)), mesh_(mesh) {
        number_ = faces.find("face_indices", false);
        const std::size_t face_bytes =  // of a triangle
            Source::is_binary ? faces.least_bytes() + 3 * size_of(corners_.type) : 8;
        mesh_.indices.resize(3 * std::min<std::uint64_t>(faces.count, in.remaining() / face_bytes));
    }

    /// Reads the faces. Returns false at a malformed number.
    bool read() {
        for (std::uint64_t face = 0; face < faces_.count; ++face) {
            if constexpr (Source::is_binary) face += read_run(faces_.count - face);
            if (face < faces_.count && !read_face()) return false;
        }
        mesh_.indices.resize(used_);
        return true;
    }

    /// Returns the number of faces that were left out because they have other than three or four
    /// corners.
    std::uint64_t left_out() const { return left_out_; }

  private:
    /// Reads consecutive faces of the usual form: a byte and three or four numbers of four bytes,
    /// among other numbers. Stops near the end of the file or of the array. Returns how many were
    /// read.
    std::uint64_t read_run(std::uint64_t most) {
        if (number_ || !is_usual()) return 0;
        const std::size_t before = bytes_before_corners();
        const std::size_t fixed = faces_.least_bytes();
        std::uint32_t* out = mesh_.indices.data() + used_;
        const std::uint32_t* const end = mesh_.indices.data() + mesh_.indices.size();
        const char* p = in_.position();
        std::uint64_t face = 0;
        for (; face < most && static_cast<std::size_t>(in_.last() - p) >= fixed + 16; ++face) {
            const char* const list = p + before;
            const unsigned count = static_cast<unsigned char>(*list);
            if ((count != 3 && count != 4) || end - out < (count == 3 ? 4 : 6)) break;
            out = Source::copy_corners(list + 1, count, out);
            p += fixed + count * 4;
        }
        in_.position() = p;
        used_ = static_cast<std::size_t>(out - mesh_.indices.data());
        return face;
    }

    bool is_usual() const {
        const auto is_other_list = [&](const Property& p) { return p.count && &p != &corners_; };
        return size_of(*corners_.count) == 1 && size_of(corners_.type) == 4 &&
               corners_.type != Type::float32 &&
               std::ranges::none_of(faces_.properties, is_other_list);
    }

    std::size_t bytes_before_corners() const {
        std::size_t bytes = 0;
        for (const Property* p = faces_.properties.data(); p != &corners_; ++p) {
            bytes += size_of(p->type);
        }
        return bytes;
    }

    bool read_face() {
        const std::size_t used = used_;
        double number = 0, ignored = 0;
        for (const Property& property : faces_.properties) {
            const bool good = &property == &corners_ ? read_corners()
                              : &property == number_ ? in_.read(property.type, number)
                              : property.count       ? skip_list(in_, property)
                                                     : in_.read(property.type, ignored);
            if (!good) return false;
        }
        if (number_) {
            mesh_.face_numbers.insert(mesh_.face_numbers.end(), (used_ - used) / 3, as_int(number));
        }
        return true;
    }

    bool read_corners() {
        double count = 0;
        if (!read_size(in_, corners_, count)) return false;
        if (count != 3 && count != 4) {
            ++left_out_;
            return in_.skip(corners_.type, static_cast<std::uint64_t>(count));
        }
        std::array<std::uint32_t, 4> corner{};
        for (int i = 0; i < count; ++i) {
            double value = 0;
            if (!in_.read(corners_.type, value)) return false;
            const bool is_index = value >= 0 && value < no_vertex;
            corner[static_cast<std::size_t>(i)] =
                is_index ? static_cast<std::uint32_t>(value) : no_vertex;
        }
        add(corner[0], corner[1], corner[2]);
        if (count == 4) add(corner[3], corner[0], corner[2]);
        return true;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (mesh_.indices.size() - used_ < 3) {
            mesh_.indices.resize(std::max<std::size_t>(96, 2 * mesh_.indices.size()));
        }
        for (const std::uint32_t corner : {a, b, c}) mesh_.indices[used_++] = corner;
    }

    static std::int32_t as_int(double number) {
        return number > -0x1p31 && number < 0x1p31 ? static_cast<std::int32_t>(number) : 0;
    }

    static constexpr std::uint32_t no_vertex = 0xFFFFFFFF;  ///< no mesh has as many

    Source& in_;
    const Element& faces_;
    const Property& corners_;
    const Property* number_;
    PlyMesh& mesh_;
    std::size_t used_ = 0;  ///< indices of the mesh that are filled
    std::uint64_t left_out_ = 0;
};

}  // namespace etalon::ply
