// Meshes in Wavefront's OBJ format, only their geometry.
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
        std::uint32_t normal = no_index;  ///< no_index if the file names none
    };

    std::vector<Vec3> vertices, normals;  ///< normals may have any length
    std::vector<std::array<Corner, 3>> triangles;
};

/// Reads `v`, `vn` and `f` and ignores everything else. A backslash at the end of a line continues
/// it on the next. A corner of a face is `v`, `v/t`, `v//n` or `v/t/n`, with numbers from 1, or -1,
/// -2, ... counted back from the last one so far. A face of more than three corners, concave or
/// not, is triangulated. A face that cannot be made is a warning.
ObjMesh read_obj(std::string_view text, DiagnosticLog& log);

/// Gives every corner a normal. If no face of the file names any, vertex i gets normal i. Normals
/// that are still missing, or zero, become the mean of those of the faces around the vertex,
/// weighted by area; zero if these have none.
void complete_normals(ObjMesh& mesh);

}  // namespace etalon
