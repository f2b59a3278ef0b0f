// etalon: renders scene files, and shows what it does with them.
#include <fmt/core.h>

#include <new>
#include <vector>

#include "app/commands.h"
#include "app/exit_status.h"

namespace {

using namespace etalon;

struct Command {
    const char* name;
    const char* summary;
    Run (*declare)(CLI::App&);
};

// To add a subcommand: one file that declares and runs it, one line here.
constexpr Command commands[] = {
    {"render", "Render a scene to EXR and PNG", declare_render},
    {"info", "Say what a scene holds and needs, without building anything", declare_info},
    {"trace", "Rays in, hits out", declare_trace},
    {"crosscheck", "The same rays through several backends and the oracle", declare_crosscheck},
};

int run(int argc, char** argv) {
    CLI::App app("Etalon: a renderer and accelerator laboratory", "etalon");
    app.set_version_flag("--version", "etalon " ETALON_VERSION);
    app.require_subcommand(1);
    app.footer("Exit status: 0 done, 1 found more differences than allowed, 2 wrong usage,\n"
               "3 the scene (or another input) is unusable, 4 output could not be written.");
    std::vector<std::pair<CLI::App*, Run>> runs;
    for (const Command& command : commands) {
        CLI::App* sub = app.add_subcommand(command.name, command.summary);
        runs.emplace_back(sub, command.declare(*sub));
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exit_done : exit_usage;
    }
    for (const auto& [sub, command] : runs) {
        if (sub->parsed()) return command();
    }
    return exit_usage;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "etalon: error: not enough memory for what was asked\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "etalon: error: {}\n", error.what());
    }
    return exit_unusable;
}
