#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "app/common/completion.h"
#include "app/common/completion_words.h"
#include "app/common/option_text.h"

namespace etalon {
namespace {

/// Returns text between quotes, as zsh reads it.
std::string zsh_quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

/// Returns text without the special characters of _arguments and _describe.
std::string zsh_literal(const std::string& text) {
    std::string literal;
    for (const char c : text) {
        if (c == ':' || c == '[' || c == ']' || c == '\\') literal += '\\';
        literal += c;
    }
    return literal;
}

/// Returns the action of _arguments for one of these words; without words, for a file.
std::string zsh_words(const std::vector<std::string>& words, bool list) {
    if (words.empty()) return "_files";
    const std::string all = fmt::format("{}", fmt::join(words, " "));
    return list ? " _sequence compadd - " + all : "(" + all + ")";
}

/// Returns a line for each name of an option: `'*--backend=[Backend ...]:NAME:(none grid ...)'`.
std::string zsh_option(const CLI::Option& option, const ValueChoices& choices) {
    std::string lines, value;
    if (has_value(option)) {
        value = fmt::format(":{}:{}", zsh_literal(option.get_type_name()),
                            zsh_words(values_of(option, choices), is_list(option)));
    }
    for (const std::string& name : names_of(option)) {
        const char* joint = value.empty() ? "" : name.starts_with("--") ? "=" : "+";
        lines += fmt::format(" \\\n            {}",
                             zsh_quoted(fmt::format("*{}{}[{}]{}", name, joint,
                                                    zsh_literal(summary_of(option)), value)));
    }
    return lines;
}

std::string zsh_options(const CLI::App& command, const ValueChoices& choices) {
    std::string lines;
    for (const CLI::Option* option : named_options(command)) lines += zsh_option(*option, choices);
    return lines;
}

/// Returns the call that completes the words after the name of a command without subcommands.
std::string zsh_arguments(const CLI::App& command, const ValueChoices& choices) {
    return fmt::format("_arguments -s{} \\\n            {}\n", zsh_options(command, choices),
                       zsh_quoted("*: :" + zsh_words(plain_words(command, choices), false)));
}

/// Text around the commands and their cases.
constexpr const char* zsh_commands_script =
    R"(    local context state state_descr line curcontext=$curcontext
    local -A opt_args
    _arguments -C{options} \
            '(-): :->command' '(-)*:: :->arguments'
    case $state in
        command)
            local -a commands=({commands}
            )
            _describe command commands ;;
        arguments)
            case $words[1] in
{cases}            esac ;;
    esac
)";

std::string zsh_body(const CLI::App& program, const ValueChoices& choices) {
    if (program.get_subcommands({}).empty()) return "    " + zsh_arguments(program, choices);
    std::string commands, cases;
    for (const CLI::App* command : program.get_subcommands({})) {
        commands += "\n                " +
                    zsh_quoted(command->get_name() + ":" + zsh_literal(command->get_description()));
        cases += fmt::format("        {}) {}            ;;\n", command->get_name(),
                             zsh_arguments(*command, choices));
    }
    return fmt::format(zsh_commands_script, fmt::arg("options", zsh_options(program, choices)),
                       fmt::arg("commands", commands), fmt::arg("cases", cases));
}

}  // namespace

std::string zsh_completion(const CLI::App& program, const ValueChoices& choices) {
    return fmt::format(
        "#compdef {0}\n# Completion of {0} for zsh, written by {0} itself.\n_{1}() {{\n{2}}}\n_{1} "
        "\"$@\"\n",
        program.get_name(), function_name(program), zsh_body(program, choices));
}

}  // namespace etalon
