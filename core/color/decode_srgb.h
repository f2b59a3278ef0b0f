#pragma once

#include <span>

namespace etalon {

/// Replaces each value by srgb_decoded() of it, rounded to float. The bits are the same; several
/// are computed at a time.
void decode_srgb(std::span<float> values);

}  // namespace etalon
