// The subcommands of etalon-bench.
#pragma once

#include "app/common/program.h"

namespace etalon {

Action declare_speed(Options& options);
Action declare_accuracy(Options& options);
Action declare_convergence(Options& options);
Action declare_frames(Options& options);
Action declare_report(Options& options);

}  // namespace etalon
