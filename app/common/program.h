// Common part of the programs: a table of subcommands, and the exit status.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>

#include "app/common/options.h"

namespace etalon {

/// Runs a subcommand once the command line has been parsed; returns the exit status.
using Action = std::function<int()>;

/// A command line that the help shows.
struct Example {
    const char* arguments;  ///< what follows the program and the subcommand
    const char* purpose;
};

struct Command {
    const char* name;
    const char* summary;
    Action (*declare)(Options&);  ///< declares the subcommand's options
    std::array<Example, 2> examples;
};

/// What a program says of itself.
struct ProgramText {
    const char* name;
    const char* description;
    std::string (*libraries)() = nullptr;  ///< lines of --version on the libraries that it loads
};

/// Parses the command line and runs what it asks for. No exception escapes.
int run_program(const ProgramText& text, std::span<const Command> commands, int argc, char** argv);

/// The same for a program that has no subcommands, but is one.
int run_program(const Command& command, int argc, char** argv);

}  // namespace etalon
