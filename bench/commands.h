// The subcommands of etalon-bench.
#pragma once

#include "app/program.h"

namespace etalon {

Action declare_speed(CLI::App& app);
Action declare_accuracy(CLI::App& app);
Action declare_convergence(CLI::App& app);
Action declare_report(CLI::App& app);

}  // namespace etalon
