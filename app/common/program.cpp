#include "app/common/program.h"

#include <fmt/core.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <CLI/CLI.hpp>
#include <new>
#include <vector>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/parse_exit.h"

namespace etalon {
namespace {

/// Keeps freed memory for the next allocation. Batches of rays take and free some hundred kilobytes
/// at a time; given back to the system each time, they cost a page fault for every four.
void keep_freed_memory() {
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
#endif
}

int run_command(CLI::App& app, std::span<const Command> commands, int argc, char** argv) {
    app.require_subcommand(1);
    app.footer(
        "Exit status: 0 done, 1 found more differences than allowed, 2 wrong usage,\n"
        "3 the scene (or another input) is unusable, 4 output could not be written.");
    std::vector<std::pair<CLI::App*, Action>> runs;
    for (const Command& command : commands) {
        CLI::App* sub = app.add_subcommand(command.name, command.summary);
        Options options(*sub);
        runs.emplace_back(sub, command.declare(options));
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return exit_after_parsing(app, error);
    }
    for (const auto& [sub, run] : runs) {
        if (sub->parsed()) return run();
    }
    return exit_usage;
}

/// Returns the exit status; no exception escapes.
int parse_and_run(const char* name, const char* description, std::span<const Command> commands,
                  int argc, char** argv) {
    try {
        CLI::App app(description, name);
        app.set_version_flag("--version", fmt::format("{} {}", name, ETALON_VERSION));
        return run_command(app, commands, argc, argv);
    } catch (const std::bad_alloc&) {
        print_message("{}: error: not enough memory for what was asked\n", name);
    } catch (const std::exception& error) {
        print_message("{}: error: {}\n", name, error.what());
    }
    return exit_unusable;
}

}  // namespace

int run_program(const char* name, const char* description, std::span<const Command> commands,
                int argc, char** argv) {
    prepare_standard_streams();
    keep_freed_memory();
    return status_after_results(name, parse_and_run(name, description, commands, argc, argv));
}

}  // namespace etalon
