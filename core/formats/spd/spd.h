// Spectra in files: text of numbers, a wavelength in nm and a value in turn.
#pragma once

#include <string_view>
#include <vector>

#include "core/color/spectrum.h"
#include "core/formats/diagnostic_log.h"

namespace etalon {

/// Reads the samples in the order of the text, which need not be sorted. Comments reach from '#' to
/// the end of the line. What is no number is passed over with a warning, as a number without a
/// partner at the end is, and a pair of which one is too large.
std::vector<SpectralSample> read_spd(std::string_view text, DiagnosticLog& log);

}  // namespace etalon
