// The text of --help.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class FormatterBase;
}

namespace etalon {

/// Returns the formatter of all programs: what a command does, its options by headings with the
/// names of their values, all wrapped at words to 80 columns, and the command's footer as it is.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Returns lines of a help text: a name, and beside it what it is, wrapped.
std::string help_entry(const std::string& name, const std::string& description);

}  // namespace etalon
