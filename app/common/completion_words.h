// What command lines are made of, for the completion of them by any shell.
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

/// Returns the options that the help shows and that have a name.
std::vector<const CLI::Option*> named_options(const CLI::App& command);

/// Returns what is known of the words that are neither options nor their values: the names of
/// subcommands, or the values of the positional arguments.
std::vector<std::string> plain_words(const CLI::App& command, const ValueChoices& choices);

/// Returns the values of an option, none where they are not certain ones.
std::vector<std::string> values_of(const CLI::Option& option, const ValueChoices& choices);

/// Returns whether the value is a list whose entries are separated by commas.
bool is_list(const CLI::Option& option);

/// Returns what the option does in a few words, the beginning of its description.
std::string summary_of(const CLI::Option& option);

}  // namespace etalon
