#pragma once

namespace etalon {

/// Reason of a failure that is not the file's fault. Readers of images end with it.
inline constexpr const char* lack_of_memory = "not enough memory";

}  // namespace etalon
