#include "core/formats/pbrt/build/lens_file.h"

#include <fmt/core.h>

#include <cmath>

#include "core/formats/file_text.h"
#include "core/formats/spectrum/number_text.h"

namespace etalon::pbrt {
namespace {

constexpr std::size_t most_surfaces = 1000;

constexpr double millimetre = 1e-3;

/// Returns why there is no such lens; empty if there is.
std::string check_surface(const LensSurface& s) {
    for (const double x : {s.curvature_radius, s.thickness, s.eta, s.aperture_radius}) {
        if (!std::isfinite(x)) return "a number of it is too large";
    }
    if (s.eta < 0) return "an index of refraction is negative";
    if (s.aperture_radius < 0) return "an aperture is negative";
    return {};
}

}  // namespace

Result<std::vector<LensSurface>> read_lens_file(const std::string& path, bool strict,
                                                DiagnosticList& log) {
    const FileText file = read_file(path, FileKind::regular);
    if (!file.error.empty()) return {{}, fmt::format("{} {}", path_in_quotes(path), file.error)};
    DiagnosticLog problems(path, file.text(), strict);
    const std::vector<PlacedNumber> numbers = read_number_text(file.text(), problems);
    log.append(problems.list());
    const std::size_t count = numbers.size() / 4;
    if (numbers.size() % 4 != 0 || count == 0 || count > most_surfaces) {
        return {{},
                fmt::format("{} has {} numbers: expected four for each of up to {} surfaces",
                            path_in_quotes(path), numbers.size(), most_surfaces)};
    }
    Result<std::vector<LensSurface>> result;
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
        const auto number = [&](std::size_t k) { return numbers[i + k].value; };
        const LensSurface surface{number(0) * millimetre, number(1) * millimetre, number(2),
                                  number(3) * millimetre / 2};
        if (const std::string why = check_surface(surface); !why.empty()) {
            return {{}, fmt::format("{}: {}", path_in_quotes(path), why)};
        }
        result.value.push_back(surface);
    }
    return result;
}

}  // namespace etalon::pbrt
