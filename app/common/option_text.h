// Names and descriptions of options, for the help and the manual pages.
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace etalon {

/// Returns "-o, --output FILE", or "SCENE...".
std::string name_of(const CLI::Option& option);

/// Returns whether the option has a value.
bool has_value(const CLI::Option& option);

/// Returns the option's description, the options that it excludes, and its default.
std::string description_of(const CLI::Option& option);

/// Returns "etalon render [OPTIONS] SCENE" for a command called as `name`.
std::string usage_of(const CLI::App& command, const std::string& name);

}  // namespace etalon
