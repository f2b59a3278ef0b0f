#pragma once

namespace etalon {

/// The reason of a failure that is not the file's fault: what reads an image ends with it.
inline constexpr const char* lack_of_memory = "not enough memory";

}  // namespace etalon
