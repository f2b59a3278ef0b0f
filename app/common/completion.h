// Completion of command lines.
#pragma once

#include <string>

#include "app/common/value_choices.h"

namespace CLI {
class App;
}

namespace etalon {

/// Return a script for a shell that completes the program's commands, their options and known
/// values; anything else is completed as a file name.
std::string bash_completion(const CLI::App& program, const ValueChoices& choices);
std::string fish_completion(const CLI::App& program, const ValueChoices& choices);
std::string zsh_completion(const CLI::App& program, const ValueChoices& choices);

/// Returns the name of the program as a shell function: etalon_bench.
std::string function_name(const CLI::App& program);

}  // namespace etalon
