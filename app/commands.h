// The subcommands of etalon.
#pragma once

#include "app/program.h"

namespace etalon {

Action declare_render(CLI::App& app);
Action declare_info(CLI::App& app);
Action declare_trace(CLI::App& app);
Action declare_crosscheck(CLI::App& app);
Action declare_compare(CLI::App& app);
Action declare_convert(CLI::App& app);

}  // namespace etalon
