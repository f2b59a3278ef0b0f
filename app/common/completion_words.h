// Words of command lines, for their completion by any shell.
#pragma once

#include <string>
#include <vector>

#include "app/common/value_choices.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace etalon {

/// Returns "-b" and "--backend".
std::vector<std::string> names_of(const CLI::Option& option);

/// Returns the options that have a name and are shown in the help.
std::vector<const CLI::Option*> named_options(const CLI::App& command);

/// Returns the known words that are neither options nor their values: the names of subcommands, or
/// the values of the positional arguments.
std::vector<std::string> plain_words(const CLI::App& command, const ValueChoices& choices);

/// Returns the known values of an option; none if any value is allowed.
std::vector<std::string> values_of(const CLI::Option& option, const ValueChoices& choices);

/// Returns whether the value is a list whose entries are separated by commas.
bool is_list(const CLI::Option& option);

/// Returns a short description of the option, the beginning of its help.
std::string summary_of(const CLI::Option& option);

}  // namespace etalon
