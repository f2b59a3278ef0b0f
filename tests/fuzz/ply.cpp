#include "core/formats/ply/ply.h"

#include <cmath>

#include "tests/fuzz/target.h"

namespace etalon::fuzz {
namespace {

void run(std::string_view bytes) {
    DiagnosticLog log("mesh.ply", bytes, false);
    const auto mesh = read_ply(bytes, log);
    require(mesh || log.has_errors(), "neither a mesh nor an error");
    if (!mesh) return;
    require(mesh->indices.size() % 3 == 0, "a triangle of fewer than three corners");
    for (const std::uint32_t v : mesh->indices) {
        require(std::size_t{3} * v + 2 < mesh->positions.size(), "a corner without a vertex");
        for (std::size_t k = 0; k < 3; ++k) {
            require(std::isfinite(mesh->positions[std::size_t{3} * v + k]),
                    "a position that is not finite");
        }
    }
}

}  // namespace

const Target target = {run, true};

}  // namespace etalon::fuzz
