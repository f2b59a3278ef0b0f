#include <cmath>

#include "core/formats/pbrt/build/lens_file.h"
#include "tests/fuzz/target.h"
#include "tests/temporary_folder.h"

namespace etalon::fuzz {
namespace {

void run(std::string_view text) {
    test::put("lens.dat", text);
    DiagnosticList log;
    const auto surfaces = pbrt::read_lens_file("lens.dat", false, log);
    require(surfaces || !surfaces.error.empty(), "neither a lens nor an error");
    for (const LensSurface& s : surfaces.value) {
        require(std::isfinite(s.curvature_radius) && std::isfinite(s.thickness),
                "a surface that is not finite");
    }
}

}  // namespace

const Target target = {run, true};

}  // namespace etalon::fuzz
