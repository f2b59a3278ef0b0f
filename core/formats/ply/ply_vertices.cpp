#include "core/formats/ply/ply_vertices.h"

namespace etalon::ply {
namespace {

/// Makes the named properties, if the vertices have all of them, the columns of an array.
template <std::size_t n>
bool add_array(const Element& vertices, const std::array<std::string_view, n>& names,
               FilledLater<float>& array, std::vector<Column>& columns) {
    std::array<std::size_t, n> found;
    for (std::size_t k = 0; k < n; ++k) {
        const Property* const property = vertices.find(names[k], false);
        if (!property) return false;
        found[k] = static_cast<std::size_t>(property - vertices.properties.data());
    }
    array.resize(n * vertices.count);
    for (std::size_t k = 0; k < n; ++k) columns[found[k]] = {&array[k], n};
    return true;
}

}  // namespace

std::vector<Column> make_columns(const Element& vertices, PlyMesh& mesh) {
    using Pair = std::array<std::string_view, 2>;
    using Triple = std::array<std::string_view, 3>;
    std::vector<Column> columns(vertices.properties.size());
    add_array(vertices, Triple{"x", "y", "z"}, mesh.positions, columns);
    add_array(vertices, Triple{"nx", "ny", "nz"}, mesh.normals, columns);
    for (const Pair& names : {Pair{"u", "v"}, Pair{"s", "t"}, Pair{"texture_u", "texture_v"},
                              Pair{"texture_s", "texture_t"}}) {
        if (add_array(vertices, names, mesh.uvs, columns)) break;
    }
    return columns;
}

}  // namespace etalon::ply
