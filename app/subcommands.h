// The subcommands of etalon.
#pragma once

#include "app/common/program.h"

namespace etalon {

Action declare_render(Options& options);
Action declare_serve(Options& options);
Action declare_info(Options& options);
Action declare_trace(Options& options);
Action declare_crosscheck(Options& options);
Action declare_compare(Options& options);
Action declare_convert(Options& options);
Action declare_merge(Options& options);

}  // namespace etalon
