// Common part of the two programs: a table of subcommands, and the exit status.
#pragma once

#include <functional>
#include <span>

#include "app/common/options.h"

namespace etalon {

/// Runs a subcommand once the command line has been parsed; returns the exit status.
using Action = std::function<int()>;

struct Command {
    const char* name;
    const char* summary;
    Action (*declare)(Options&);  ///< declares the subcommand's options
};

/// Parses the command line and runs what it asks for. No exception escapes.
int run_program(const char* name, const char* description, std::span<const Command> commands,
                int argc, char** argv);

}  // namespace etalon
