// Manual pages.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace etalon {

/// Returns the manual page, in roff's man macros, of a program or of one of its subcommands, with
/// the contents of its help. `name` is how it is called, "etalon render"; the page is
/// "etalon-render".
std::string man_page(const CLI::App& command, const std::string& name);

}  // namespace etalon
