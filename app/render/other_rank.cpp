#include "app/render/other_rank.h"

#include <string>
#include <vector>

#include "app/common/exit_status.h"
#include "app/common/signals.h"
#include "app/mpi/tile_worker.h"
#include "app/render/fail_with.h"
#include "app/render/kept_state.h"
#include "app/render/prepared_scene.h"
#include "app/render/scene_source.h"
#include "core/render/renderer.h"

namespace etalon {

int render_for_rank_0(RenderArguments a, Ranks& ranks) {
    const SignalGuard signals;  // a copy of the scene is removed
    KeptState kept(a, true);
    SceneSource source(a, ranks);
    if (const std::string error = source.receive(); !error.empty()) {
        return fail_with(error), exit_unusable;
    }
    if (source.is_over()) return exit_done;
    PreparedScene prepared(a);
    if (const int status = prepared.load(source); status != exit_done) return status;
    if (!prepared.build()) return exit_unusable;
    kept.identify(source.path_read(), prepared.scene(), prepared.settings());
    const auto find_problems = [&] {
        std::vector<std::string> problems = prepared.integrator().late_problems();
        for (std::string& problem : problems) problem = source.at_rank_0(problem);
        return problems;
    };
    const auto work = [&](const TileTask& task) {
        TileWorker(ranks, find_problems).run(task, kept.identity());
    };
    render_dealt_tiles(prepared.scene().camera, prepared.integrator(), prepared.settings(), work);
    return exit_done;
}

}  // namespace etalon
