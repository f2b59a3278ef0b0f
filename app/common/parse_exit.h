#pragma once

#include <CLI/CLI.hpp>
#include <sstream>

#include "app/common/console.h"
#include "app/common/exit_status.h"

namespace etalon {

/// Writes what the end of parsing asks for, the help or what is wrong, and returns the exit status.
inline int exit_after_parsing(const CLI::App& app, const CLI::Error& end) {
    std::ostringstream results, messages;
    const bool is_done = app.exit(end, results, messages) == 0;
    write_result(results.str());
    write_message(messages.str());
    return is_done ? exit_done : exit_usage;
}

}  // namespace etalon
