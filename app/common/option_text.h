// How options are called and described, for the help and the manual pages.
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace etalon {

/// Returns "-o, --output FILE", or "SCENE...".
std::string name_of(const CLI::Option& option);

/// Returns whether a value follows the name of the option.
bool has_value(const CLI::Option& option);

/// Returns what the option does, which others it excludes, and its default.
std::string description_of(const CLI::Option& option);

/// Returns "etalon render [OPTIONS] SCENE" for a command called as `name`.
std::string usage_of(const CLI::App& command, const std::string& name);

}  // namespace etalon
