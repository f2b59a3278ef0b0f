#pragma once

#include "app/mpi/ranks.h"
#include "app/render/arguments.h"

namespace etalon {

/// Renders tiles for rank 0, which does everything else. Returns the exit status, and prints why if
/// it is not 0.
int render_for_rank_0(RenderArguments arguments, Ranks& ranks);

}  // namespace etalon
