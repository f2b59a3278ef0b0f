#pragma once

#include <optional>
#include <string_view>

namespace etalon::pbrt {

/// A number as C's strtof reads it, and further characters that it would ignore.
struct LooseNumber {
    double value;            ///< may be infinite or not a number
    std::string_view extra;  ///< characters after the number
};

/// Returns nothing if the word does not start with a decimal number, "inf" or "nan".
std::optional<LooseNumber> read_number(std::string_view word);

/// Rounds the nearest double of the decimal number [first, last) to the nearest float of the
/// number itself; a float out of range is infinite.
float to_float(double nearest, const char* first, const char* last);

}  // namespace etalon::pbrt
