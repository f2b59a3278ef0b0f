// What remains of a rendering that is over: images with AOVs, statistics, and a line on the
// terminal.
#pragma once

#include "app/mpi/rank_dealer.h"
#include "app/render/arguments.h"
#include "app/render/kept_state.h"
#include "app/render/prepared_scene.h"
#include "app/render/reference.h"
#include "app/stats.h"
#include "core/render/renderer.h"

namespace etalon {

/// A rendering that is over, and what took part in it.
struct FinishedRendering {
    const RenderArguments& arguments;
    const PreparedScene& prepared;
    const Rendering& rendering;
    const KeptState& kept;
    const Reference* reference;  ///< null if there is none
    const RankDealer* dealer;    ///< null if there is one process
};

/// What could be written.
struct WrittenResults {
    bool files;     ///< all images and statistics
    bool channels;  ///< all AOVs; false if memory was lacking
};

/// Writes all results, and prints why if something cannot be written. `stats` has the times of the
/// steps so far; the stopwatch measures since the last of them.
WrittenResults write_results(const FinishedRendering& finished, RenderStats& stats,
                             Stopwatch& watch);

}  // namespace etalon
