// The build and the command line of a program; needs no library.
#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// Description of the build of the programs.
struct BuildFacts {
    std::string_view version;
    std::string_view commit;  ///< of Git, or "unknown"
    std::string_view compiler, flags;
};
const BuildFacts& build_facts();

/// Returns a word of a command line, in quotes if a POSIX shell needs them.
std::string shell_quoted(std::string_view word);

/// Stores the name with which a program's messages begin. Must be called once, before threads
/// start.
void note_program_name(const std::string& name);

/// Returns that name.
const std::string& program_name();

/// Stores the command line. Must be called once, before threads start.
void note_command_line(int argc, char** argv);

/// Returns the command line, each word quoted as a POSIX shell needs it.
const std::string& command_line();

/// Returns how to call a program of Etalon that is beside this one, quoted: build/bin/etalon, or
/// etalon if this one was found by PATH.
std::string sibling_program(const std::string& name);

}  // namespace etalon
