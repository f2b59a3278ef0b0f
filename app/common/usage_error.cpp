#include "app/common/usage_error.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/formats/nearest_name.h"

namespace etalon {
namespace {

using Names = std::vector<std::string>;

/// Tells the kind by the exit code, as the name of CLI11's ExtrasError is that of the subcommand.
bool is_kind(const CLI::ParseError& error, CLI::ExitCodes kind) {
    return error.get_exit_code() == static_cast<int>(kind);
}

/// Returns the subcommand of the command line, else the program.
const CLI::App& chosen_command(const CLI::App& program) {
    const auto chosen = program.get_subcommands();
    return chosen.empty() ? program : *chosen.front();
}

bool is_option(const std::string& argument) {
    return argument.size() > 1 && argument[0] == '-' &&
           argument.find_first_not_of("-0123456789.") != std::string::npos;
}

/// Returns "no option --ssp; did you mean --spp?"
std::string unknown_option(const CLI::App& command, const std::string& argument) {
    const std::string given = argument.substr(0, argument.find('='));
    Names names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back(name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::size_t dashes = std::min(given.find_first_not_of('-'), given.size());
    const std::string_view near = nearest_name(given.substr(dashes), views);
    return fmt::format("no option {}{}", given,
                       near.empty() ? "" : fmt::format("; did you mean --{}?", near));
}

std::string unknown_command(const CLI::App& program, const Names& arguments) {
    Names names;
    for (const CLI::App* command : program.get_subcommands({}))
        names.push_back(command->get_name());
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string list = fmt::format("; expected {}", fmt::join(names, ", "));
    if (arguments.empty()) return "no command given" + list;
    const std::string near = did_you_mean(arguments.front(), views);
    return fmt::format("no command '{}'{}", arguments.front(), near.empty() ? list : near);
}

/// Returns the message for unknown arguments.
std::string unknown_argument(const CLI::App& program, const Names& arguments) {
    const CLI::App& command = chosen_command(program);
    const bool needs_command = &command == &program && !program.get_subcommands({}).empty();
    if (needs_command && !is_option(arguments.front())) return unknown_command(program, arguments);
    const auto end_of_options = std::ranges::find(arguments, "--");
    const auto option = std::find_if(arguments.begin(), end_of_options, is_option);
    if (option != end_of_options) return unknown_option(command, *option);
    return fmt::format("unexpected argument '{}'", arguments.back());
}

/// Returns the message for a wrong value or number of values, without CLI11's types and counts.
std::string wrong_value(const CLI::App& command, const CLI::ParseError& error) {
    std::string text = error.what();
    const std::size_t colon = text.find(": ");
    if (colon == std::string::npos) return text;
    if (is_kind(error, CLI::ExitCodes::ValidationError)) return text.replace(colon, 2, " ");
    if (!is_kind(error, CLI::ExitCodes::ArgumentMismatch)) return text;
    const std::string name = text.substr(0, colon);
    const CLI::Option* option = command.get_option_no_throw(name);
    if (option && option->count() > 1) return name + ": given more than once";
    return name + ": expected a value";
}

std::string reason(const CLI::App& program, const CLI::ParseError& error) {
    const bool is_missing = is_kind(error, CLI::ExitCodes::RequiredError);
    if (is_missing || is_kind(error, CLI::ExitCodes::ExtrasError)) {
        const Names arguments = program.remaining(true);
        const bool has_command = &chosen_command(program) != &program;
        if (!arguments.empty()) return unknown_argument(program, arguments);
        if (!has_command && !program.get_subcommands({}).empty())
            return unknown_command(program, {});
    }
    return wrong_value(chosen_command(program), error);
}

}  // namespace

std::string usage_error(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& command = chosen_command(program);
    const std::string name =
        program.get_name() + (&command == &program ? "" : " " + command.get_name());
    return fmt::format("{}: error: {}\nRun '{} --help' for help.\n", program.get_name(),
                       reason(program, error), name);
}

}  // namespace etalon
