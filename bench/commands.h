// The subcommands of etalon-bench.
#pragma once

#include "app/program.h"

namespace etalon {

Run declare_speed(CLI::App& app);
Run declare_accuracy(CLI::App& app);
Run declare_convergence(CLI::App& app);
Run declare_report(CLI::App& app);

}  // namespace etalon
