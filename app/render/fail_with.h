#pragma once

#include <string>

#include "app/common/console.h"

namespace etalon {

/// Prints why something failed. Returns false, for the caller to return.
inline bool fail_with(const std::string& message) {
    print_message("etalon: error: {}\n", message);
    return false;
}

}  // namespace etalon
