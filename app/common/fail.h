#pragma once

#include <string>

#include "app/common/console.h"
#include "app/common/program_facts.h"

namespace etalon {

/// Prints why the program fails, as one line. Returns the exit status, for the caller to return.
inline int fail(int status, const std::string& message) {
    print_message("{}: error: {}\n", program_name(), message);
    return status;
}

}  // namespace etalon
