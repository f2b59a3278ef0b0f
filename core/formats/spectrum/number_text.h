// Text of numbers and comments, as pbrt-v3 stores spectra and lenses.
#pragma once

#include <string_view>
#include <vector>

#include "core/formats/diagnostic_log.h"

namespace etalon {

struct PlacedNumber {
    double value;  ///< NaN if it does not fit a float
    std::size_t offset;
};

/// Reads the numbers of a text. Comments reach from '#' to the end of the line; words that are not
/// numbers are skipped with a warning.
std::vector<PlacedNumber> read_number_text(std::string_view text, DiagnosticLog& log);

}  // namespace etalon
