// The subcommands of etalon.
#pragma once

#include "app/program.h"

namespace etalon {

Run declare_render(CLI::App& app);
Run declare_info(CLI::App& app);
Run declare_trace(CLI::App& app);
Run declare_crosscheck(CLI::App& app);
Run declare_compare(CLI::App& app);
Run declare_convert(CLI::App& app);

}  // namespace etalon
