#pragma once

#include <optional>
#include <string_view>

namespace etalon::pbrt {

/// A number as C's strtof reads it, and the further characters that strtof would ignore.
struct LooseNumber {
    double value;            ///< may be infinite or not a number
    std::string_view extra;  ///< characters after the number
};

/// Reads a word as a number; nothing if it does not start with a decimal number, "inf" or "nan".
std::optional<LooseNumber> read_number(std::string_view word);

/// Returns the float nearest to the decimal number [first, last), of which `nearest` is the nearest
/// double. A float out of range is infinite.
float to_float(double nearest, const char* first, const char* last);

}  // namespace etalon::pbrt
