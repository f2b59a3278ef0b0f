// The subcommands of etalon-bench.
#pragma once

#include "app/program.h"

namespace etalon {

Run declare_speed(Options& options);
Run declare_accuracy(Options& options);
Run declare_convergence(Options& options);
Run declare_report(Options& options);

}  // namespace etalon
