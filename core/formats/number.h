// Decimal numbers as scene files write them: 5. .5 +1 1e-3, with '.' in every locale.
#pragma once

#include <cstdint>

namespace etalon {

enum class NumberStatus : std::uint8_t { ok, malformed, out_of_range };

struct ScannedNumber {
    const char* end;  ///< behind the number; unspecified if it is malformed
    NumberStatus status;
};

/// Reads the longest number with which [first, last) starts, correctly rounded; a number too small
/// for the type is zero. "inf", "nan" and hexadecimal numbers are malformed.
ScannedNumber scan_number(const char* first, const char* last, double& value);
ScannedNumber scan_number(const char* first, const char* last, float& value);

/// The same for an integer, which has no point and no exponent.
ScannedNumber scan_number(const char* first, const char* last, std::int64_t& value);

}  // namespace etalon
