#pragma once

#include <string>

#include "app/common/console.h"

namespace etalon {

/// Says why something failed. Returns false, which is what the caller then is to say.
inline bool complain(const std::string& message) {
    print_message("etalon: error: {}\n", message);
    return false;
}

}  // namespace etalon
