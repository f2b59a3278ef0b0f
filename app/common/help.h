// The text of --help.
#pragma once

#include <memory>
#include <string>

namespace CLI {
class FormatterBase;
}

namespace etalon {

/// Returns the formatter of all programs: the description of a command, its options under headings
/// with the names of their values, all wrapped at words to 80 columns, and the command's footer
/// unchanged.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Returns lines of a help text: a name and, beside it, its description, wrapped.
std::string help_entry(const std::string& name, const std::string& description);

}  // namespace etalon
