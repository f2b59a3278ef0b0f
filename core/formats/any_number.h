// Reads numbers of any length, carefully rather than fast.
#pragma once

#include "core/formats/number.h"

namespace etalon {

/// Reads a number as scan_number() does. T is float or double.
template <class T>
ScannedNumber scan_any_number(const char* first, const char* last, T& value);

}  // namespace etalon
