// The subcommands. Each declares its options on the given CLI11 app and returns what runs it once
// the command line has been parsed; the result is the program's exit status.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace etalon {

using Run = std::function<int()>;

Run declare_render(CLI::App& app);
Run declare_info(CLI::App& app);
Run declare_trace(CLI::App& app);
Run declare_crosscheck(CLI::App& app);

}  // namespace etalon
