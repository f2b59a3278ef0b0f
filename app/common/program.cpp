#include "app/common/program.h"

#include <fmt/core.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "app/common/console.h"
#include "app/common/documentation.h"
#include "app/common/exit_status.h"
#include "app/common/help.h"
#include "app/common/memory_limit.h"
#include "app/common/program_facts.h"
#include "app/common/started_rank.h"
#include "app/common/usage_error.h"

namespace etalon {
namespace {

/// Keeps freed memory for the next allocation. Batches of rays allocate and free some hundred
/// kilobytes at a time; returning them to the system would cost a page fault for every four.
void keep_freed_memory() {
#if defined(__GLIBC__)
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
#endif
}

std::terminate_handler usual_end = nullptr;

/// Ends the program with a message if memory runs out in code that cannot throw: the destructors of
/// JSON allocate.
void end_without_memory() {
    try {
        if (const std::exception_ptr reason = std::current_exception()) {
            std::rethrow_exception(reason);
        }
    } catch (const std::bad_alloc&) {
        write_message("error: not enough memory for what was asked\n");
        std::_Exit(exit_unusable);
    } catch (...) {
    }
    usual_end();
}

constexpr const char* exit_statuses =
    "Exit status: 0 done, 1 found more differences than allowed, 2 wrong usage,\n"
    "3 the scene (or another input) is unusable, 4 output could not be written.\n";

/// Returns the parser of a program.
struct CommandLine {
    CLI::App program;
    ValueChoices choices;
};

/// Declares a command in its part of the parser; `name` is how it is called.
Action declare(const Command& command, const std::string& name, CLI::App& parser,
               ValueChoices& choices) {
    Options options(parser, choices);
    Action run = command.declare(options);
    std::string footer = parser.get_footer() + "Examples:\n";
    for (const Example& example : command.examples) {
        footer += fmt::format("  {} {}\n      {}\n", name, example.arguments, example.purpose);
    }
    parser.footer(footer + "\n" + exit_statuses);
    return [tasks = options.when_parsed(), run] {
        for (const auto& task : tasks) task();
        return run();
    };
}

/// Parses the command line; returns an exit status if nothing is to be run, as after --help.
std::optional<int> parse(CommandLine& line, int argc, char** argv) {
    CLI::App& program = line.program;
    // Only for the installation, so the help does not list it.
    if (argc == 3 && std::string_view(argv[1]) == "--write-documentation") {
        return write_documentation(program, line.choices, argv[2]) ? exit_done : exit_not_written;
    }
    try {
        program.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        const bool is_said = started_rank().rank > 0;  // by rank 0, which has the same command line
        if (is_said) return error.get_exit_code() == 0 ? exit_done : exit_usage;
        if (error.get_exit_code() != 0) {
            write_message(usage_error(program, error));
            return exit_usage;
        }
        std::ostringstream text;
        program.exit(error, text);
        write_result(text.str());
        return exit_done;
    }
}

int parse_and_run(CommandLine& line, std::span<const Command> commands, int argc, char** argv) {
    CLI::App& program = line.program;
    program.require_subcommand(1);
    std::vector<std::pair<CLI::App*, Action>> runs;
    for (const Command& command : commands) {
        CLI::App* const sub = program.add_subcommand(command.name, command.summary);
        runs.emplace_back(
            sub, declare(command, program.get_name() + " " + command.name, *sub, line.choices));
    }
    program.footer(exit_statuses);
    if (const std::optional<int> status = parse(line, argc, argv)) return *status;
    for (const auto& [sub, run] : runs) {
        if (sub->parsed()) return run();
    }
    return exit_usage;
}

std::string version_text(const ProgramText& text) {
    const BuildFacts& build = build_facts();
    const std::string libraries = text.libraries ? "\n" + text.libraries() : "";
    return fmt::format("{} {}\ncommit {}\ncompiler {}\nflags {}{}", text.name, build.version,
                       build.commit, build.compiler, build.flags, libraries);
}

/// Runs `task` with the parser of a program; turns exceptions into a message and a status.
template <class Task>
int guarded(const ProgramText& text, int argc, char** argv, const Task& task) {
    try {
        note_command_line(argc, argv);
        CommandLine line{CLI::App(text.description, text.name), {}};
        line.program.formatter(help_formatter());
        line.program.set_version_flag("--version", [&] { return version_text(text); });
        return task(line);
    } catch (const std::bad_alloc&) {
        print_message("{}: error: not enough memory for what was asked: the program may take {}\n",
                      text.name, bytes_text(memory_limit()));
    } catch (const std::exception& error) {
        print_message("{}: error: {}\n", text.name, error.what());
    }
    return exit_unusable;
}

/// Runs a program and returns its exit status.
template <class Task>
int run_prepared(const ProgramText& text, int argc, char** argv, const Task& task) {
    usual_end = std::set_terminate(end_without_memory);
    note_program_name(text.name);
    prepare_standard_streams();
    keep_freed_memory();
    return status_after_results(text.name, guarded(text, argc, argv, task));
}

}  // namespace

int run_program(const ProgramText& text, std::span<const Command> commands, int argc, char** argv) {
    return run_prepared(text, argc, argv, [&](CommandLine& line) {
        return parse_and_run(line, commands, argc, argv);
    });
}

int run_program(const Command& command, int argc, char** argv) {
    return run_prepared({command.name, command.summary}, argc, argv, [&](CommandLine& line) {
        const Action run = declare(command, command.name, line.program, line.choices);
        const std::optional<int> status = parse(line, argc, argv);
        return status ? *status : run();
    });
}

}  // namespace etalon
