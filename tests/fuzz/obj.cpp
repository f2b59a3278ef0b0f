#include "core/formats/obj.h"

#include "tests/fuzz/target.h"

namespace etalon::fuzz {
namespace {

void run(std::string_view text) {
    DiagnosticLog log("mesh.obj", text, false);
    ObjMesh mesh = read_obj(text, log);
    complete_normals(mesh);
    for (const auto& triangle : mesh.triangles) {
        for (const ObjMesh::Corner& corner : triangle) {
            require(corner.vertex < mesh.vertices.size(), "a corner without a vertex");
            require(corner.normal < mesh.normals.size(), "a corner without a normal");
        }
    }
}

}  // namespace

const Target target = {run, true};

}  // namespace etalon::fuzz
