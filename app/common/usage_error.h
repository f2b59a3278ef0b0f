#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace etalon {

/// Returns what is wrong with a command line that CLI11 rejected, with the nearest name if one was
/// misspelt and, on a second line, how to get help.
std::string usage_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace etalon
