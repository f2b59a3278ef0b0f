// Meshes in Wavefront's OBJ format, as far as it says where a surface is.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic_log.h"
#include "core/numerics/vec.h"
#include "core/scene/shapes.h"

namespace etalon {

struct ObjMesh {
    struct Corner {
        std::uint32_t vertex;
        std::uint32_t normal = no_index;  ///< no_index: the file names none
    };

    std::vector<Vec3> vertices, normals;  ///< the normals of any length
    std::vector<std::array<Corner, 3>> triangles;
};

/// Reads `v`, `vn` and `f` and passes over everything else. A corner of a face is `v`, `v/t`,
/// `v//n` or `v/t/n`, numbers from 1 or, from the last one so far, -1, -2, ... A face of more than
/// three corners, concave or not, is cut into triangles. One that cannot be made is a warning.
ObjMesh read_obj(std::string_view text, DiagnosticLog& log);

/// Gives every corner a normal. Where no face of the file names any, the i-th is that of the i-th
/// vertex. What is still missing, or zero, is the mean of the faces about the vertex, weighted by
/// their areas; zero where they have none.
void complete_normals(ObjMesh& mesh);

}  // namespace etalon
