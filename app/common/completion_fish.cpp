#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "app/common/completion.h"
#include "app/common/completion_words.h"
#include "app/common/option_text.h"

namespace etalon {
namespace {

/// Returns text between quotes, as fish reads it.
std::string fish_quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "'";
}

/// Returns the completion after the names of an option with a value. A list grows by an entry.
std::string fish_value(const CLI::Option& option, const ValueChoices& choices) {
    const std::vector<std::string> known = values_of(option, choices);
    if (known.empty()) return " -r -F";
    const std::string words = fmt::format("{}", fmt::join(known, " "));
    return " -x -a " + fish_quoted(is_list(option) ? "(__fish_append , " + words + ")" : words);
}

std::string fish_option(const CLI::Option& option, const ValueChoices& choices) {
    std::string text;
    for (const std::string& name : option.get_snames()) text += " -s " + name;
    for (const std::string& name : option.get_lnames()) text += " -l " + name;
    if (has_value(option)) text += fish_value(option, choices);
    return text + " -d " + fish_quoted(summary_of(option)) + "\n";
}

/// Returns lines that begin with `begin`, for the words after the name of a command.
std::string fish_lines(const CLI::App& command, const std::string& begin,
                       const ValueChoices& choices) {
    std::string lines;
    for (const CLI::App* sub : command.get_subcommands({})) {
        lines += fmt::format("{} -f -a {} -d {}\n", begin, sub->get_name(),
                             fish_quoted(sub->get_description()));
    }
    for (const CLI::Option* option : named_options(command)) {
        lines += begin + fish_option(*option, choices);
    }
    const std::vector<std::string> words = plain_words(command, choices);
    if (!command.get_subcommands({}).empty() || words.empty()) return lines;
    return lines + fmt::format("{} -f -a {}\n", begin,
                               fish_quoted(fmt::format("{}", fmt::join(words, " "))));
}

}  // namespace

std::string fish_completion(const CLI::App& program, const ValueChoices& choices) {
    const std::string& name = program.get_name();
    const std::string begin = "complete -c " + name;
    std::string lines = fmt::format("# Completion of {0} for fish, written by {0} itself.\n", name);
    const bool has_commands = !program.get_subcommands({}).empty();
    lines +=
        fish_lines(program, begin + (has_commands ? " -n __fish_use_subcommand" : ""), choices);
    for (const CLI::App* command : program.get_subcommands({})) {
        lines += fish_lines(
            *command,
            fmt::format("{} -n '__fish_seen_subcommand_from {}'", begin, command->get_name()),
            choices);
    }
    return lines;
}

}  // namespace etalon
