// Documentation that is installed with a program.
#pragma once

#include <filesystem>

#include "app/common/value_choices.h"

namespace CLI {
class App;
}

namespace etalon {

/// Writes the manual pages of the program and its subcommands to `folder`/man1, and the completion
/// of its command line to `folder`/completions, with a folder for each of the shells bash, fish and
/// zsh. Returns false, after a message, if that failed.
bool write_documentation(const CLI::App& program, const ValueChoices& choices,
                         const std::filesystem::path& folder);

}  // namespace etalon
