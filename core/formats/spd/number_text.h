// Text of numbers and comments, as pbrt-v3 keeps spectra and lenses in.
#pragma once

#include <string_view>
#include <vector>

#include "core/formats/diagnostic_log.h"

namespace etalon {

struct PlacedNumber {
    double value;  ///< NaN for one that a float cannot hold
    std::size_t offset;
};

/// Reads the numbers of a text. Comments reach from '#' to the end of the line; what is no number
/// is passed over with a warning.
std::vector<PlacedNumber> read_number_text(std::string_view text, DiagnosticLog& log);

}  // namespace etalon
