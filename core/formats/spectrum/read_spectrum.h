// Spectra in files: text of alternating wavelengths in nm and values.
#pragma once

#include <string_view>
#include <vector>

#include "core/color/spectrum.h"
#include "core/formats/diagnostic_log.h"

namespace etalon {

/// Reads the samples in the order of the text, which need not be sorted. Comments reach from '#' to
/// the end of the line. Words that are not numbers, an unpaired number at the end, and pairs with a
/// number that is too large are skipped with a warning.
std::vector<SpectralSample> read_spectrum(std::string_view text, DiagnosticLog& log);

}  // namespace etalon
