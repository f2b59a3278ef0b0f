#include "core/formats/spectrum/read_spectrum.h"

#include <cmath>

#include "tests/fuzz/target.h"

namespace etalon::fuzz {
namespace {

void run(std::string_view text) {
    DiagnosticLog log("light.spd", text, false);
    for (const SpectralSample& s : read_spectrum(text, log)) {
        require(std::isfinite(s.wavelength) && std::isfinite(s.value),
                "a sample that is not finite");
    }
}

}  // namespace

const Target target = {run, true};

}  // namespace etalon::fuzz
