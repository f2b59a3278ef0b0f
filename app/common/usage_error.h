#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace etalon {

/// Says what is wrong with a command line that CLI11 refused, with the nearest name where one was
/// misspelt, and, on a second line, where the help is.
std::string usage_error(const CLI::App& program, const CLI::ParseError& error);

}  // namespace etalon
