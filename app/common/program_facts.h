// How a program was built and called: what it knows of itself without any library.
#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// The build of the programs.
struct BuildFacts {
    std::string_view version;
    std::string_view commit;  ///< of Git, "unknown" where there was none
    std::string_view compiler, flags;
};
const BuildFacts& build_facts();

/// Notes how the program was called. To be called once, before threads start.
void note_command_line(int argc, char** argv);

/// How the program was called, each word quoted as a POSIX shell needs it.
const std::string& command_line();

}  // namespace etalon
