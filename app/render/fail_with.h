#pragma once

#include <string>

#include "app/common/console.h"

namespace etalon {

/// Prints why something failed: a line, or those of another rank. Returns false, for the caller to
/// return.
inline bool fail_with(const std::string& message) {
    write_message("etalon: error: " + message + "\n");
    return false;
}

}  // namespace etalon
