// Completion of command lines.
#pragma once

#include <string>

#include "app/common/value_choices.h"

namespace CLI {
class App;
}

namespace etalon {

/// Return a script for a shell that completes the program's commands, their options and the values
/// that are known; anything else is completed as the name of a file.
std::string bash_completion(const CLI::App& program, const ValueChoices& choices);
std::string fish_completion(const CLI::App& program, const ValueChoices& choices);
std::string zsh_completion(const CLI::App& program, const ValueChoices& choices);

/// Returns the name of the program as shells take it for a function: etalon_bench.
std::string function_name(const CLI::App& program);

}  // namespace etalon
