// Manual pages.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace etalon {

/// Returns the manual page, in the man macros of roff, of a program or of one of its subcommands:
/// what its help says. `name` is how it is called, "etalon render"; the page is "etalon-render".
std::string man_page(const CLI::App& command, const std::string& name);

}  // namespace etalon
