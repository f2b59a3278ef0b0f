// Completion of command lines.
#pragma once

#include <string>

#include "app/common/value_choices.h"

namespace CLI {
class App;
}

namespace etalon {

/// Returns a script for bash that completes the program's commands, their options and the values
/// that are known; anything else is completed as the name of a file.
std::string completion_script(const CLI::App& program, const ValueChoices& choices);

}  // namespace etalon
