#include <array>
#include <cstddef>
#include <new>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/started_rank.h"
#include "app/mpi/ranks.h"
#include "app/mpi/tile_message.h"
#include "app/render/fail_with.h"
#include "app/render/image_files.h"
#include "app/render/other_rank.h"
#include "app/render/render_run.h"
#include "app/subcommands.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// Time that rank 0 waits for the others to leave after a signal, as one of them may have died.
constexpr double patience_after_signal = 1;

/// Limits the threads for the lifetime of the process. When a limit is lifted, oneTBB starts more
/// threads; if memory has run out it then ends the program, or waits for ever. So the limit is
/// never lifted.
void limit_threads(int threads) {
    alignas(ThreadLimit) static std::array<std::byte, sizeof(ThreadLimit)> room;
    [[maybe_unused]] static const auto* const limit = new (room.data()) ThreadLimit(threads);
}

/// Runs the subcommand in this process alone, or with other ranks.
int run_first_rank(const RenderArguments& arguments, Ranks& ranks) {
    double patience = infinity;
    const int status = [&] {
        RenderRun run(arguments, ranks);
        const int its_status = run.run();
        if (run.is_interrupted()) patience = patience_after_signal;
        return its_status;
    }();
    ranks.leave(patience);
    return status;
}

/// Runs the subcommand in a rank that reports nothing but why it failed, to rank 0.
int run_other_rank(const RenderArguments& arguments, Ranks& ranks) {
    hold_messages();
    int status = exit_unusable;
    try {
        status = render_for_rank_0(arguments, ranks);
    } catch (const std::exception& e) {
        fail_with(e.what());
    }
    if (status != exit_done) {
        ranks.send(0, message_of(MessageKind::failure, held_messages()));
    }
    ranks.leave(infinity);
    return status;
}

int run_render(RenderArguments arguments) {
    const bool is_first = started_rank().rank == 0;  // MPI may change what it reads
    Ranks ranks;
    if (const std::string error = ranks.join(); !error.empty()) {
        if (is_first) fail_with(error);
        return exit_unusable;
    }
    if (arguments.outputs.empty()) arguments.outputs = {default_output(arguments.scene.path)};
    limit_threads(arguments.threads);
    return ranks.rank() == 0 ? run_first_rank(arguments, ranks) : run_other_rank(arguments, ranks);
}

}  // namespace

Action declare_render(Options& options) {
    auto arguments = std::make_shared<RenderArguments>();
    declare_render_options(options, *arguments);
    return [arguments] { return run_render(*arguments); };
}

Action declare_serve(Options& options) {
    auto arguments = std::make_shared<RenderArguments>();
    arguments->serve = true;
    declare_render_options(options, *arguments);
    options
        .add_flag("--stay", arguments->stay,
                  "Show the finished image until a signal ends the program (default: until the "
                  "pages that are open have shown it)")
        .group("Live view");
    return [arguments] { return run_render(*arguments); };
}

}  // namespace etalon
