// Common part of the programs: a table of subcommands, and the exit status.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>

#include "app/common/options.h"

namespace etalon {

/// Runs a subcommand after the command line has been parsed; returns the exit status.
using Action = std::function<int()>;

/// A command line that the help shows.
struct Example {
    const char* arguments;  ///< the words after the program and the subcommand
    const char* purpose;
};

struct Command {
    const char* name;
    const char* summary;
    Action (*declare)(Options&);  ///< declares the subcommand's options
    std::array<Example, 2> examples;
};

/// Description of a program.
struct ProgramText {
    const char* name;
    const char* description;
    std::string (*libraries)() = nullptr;  ///< lines of --version about the libraries that it loads
};

/// Parses the command line and runs the subcommand. No exception escapes.
int run_program(const ProgramText& text, std::span<const Command> commands, int argc, char** argv);

/// The same for a program without subcommands.
int run_program(const Command& command, int argc, char** argv);

}  // namespace etalon
