// The subcommands of etalon.
#pragma once

#include "app/program.h"

namespace etalon {

Run declare_render(Options& options);
Run declare_info(Options& options);
Run declare_trace(Options& options);
Run declare_crosscheck(Options& options);
Run declare_compare(Options& options);
Run declare_convert(Options& options);

}  // namespace etalon
