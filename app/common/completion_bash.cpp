#include "app/common/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/common/completion_words.h"
#include "app/common/option_text.h"

namespace etalon {
namespace {

/// A case of the script with the possible words; `before` sets the part of the word to keep.
std::string script_case(const std::string& pattern, const std::vector<std::string>& words,
                        const char* before = "") {
    return fmt::format("        {}) words=\"{}\"{} ;;\n", pattern, fmt::join(words, " "), before);
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> all;
    for (const CLI::Option* option : named_options(command)) {
        for (const std::string& name : names_of(*option)) all.push_back(name);
    }
    return all;
}

/// Returns the cases for values: the previous word is the name of an option.
std::string value_cases(const CLI::App& command, const std::string& name,
                        const ValueChoices& choices) {
    std::string cases;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional() || !has_value(*option)) continue;
        const char* before = is_list(*option) ? " before=${word%\"${word##*,}\"}" : "";
        const std::vector<std::string> known = values_of(*option, choices);
        for (const std::string& option_name : names_of(*option)) {
            const std::string pattern = fmt::format("\"{} {} \"*", name, option_name);
            cases += known.empty() ? fmt::format("        {}) ;;\n", pattern)
                                   : script_case(pattern, known, before);
        }
    }
    return cases;
}

/// Returns the cases of a command, "" for the program itself.
std::string command_cases(const CLI::App& command, const std::string& name,
                          const ValueChoices& choices) {
    return value_cases(command, name, choices) +
           script_case(fmt::format("\"{} \"*\" -\"*", name), option_names(command)) +
           script_case(fmt::format("\"{} \"*", name), plain_words(command, choices));
}

/// Text around the cases, which compare "COMMAND PREVIOUS-WORD WORD". Bash treats the "=" of
/// "--option=value" as a word of its own.
constexpr const char* script = R"(# Completion of {program} for bash, written by {program} itself.
_{function}() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
    local command="" words="" before="" i
    if [[ $word == "=" ]]; then
        word=""
    elif [[ $previous == "=" ]]; then
        previous=${{COMP_WORDS[COMP_CWORD - 2]}}
    fi
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${{COMP_WORDS[i]}} in
            {commands}) command=${{COMP_WORDS[i]}} && break ;;
        esac
    done
    case "$command $previous $word" in
{cases}    esac
    COMPREPLY=()
    [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -P "$before" -W "$words" -- "${{word#"$before"}}")
}}
complete -o bashdefault -o default -F _{function} {program}
)";

}  // namespace

std::string function_name(const CLI::App& program) {
    std::string name = program.get_name();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::string bash_completion(const CLI::App& program, const ValueChoices& choices) {
    std::vector<std::string> names;
    std::string cases;
    for (const CLI::App* command : program.get_subcommands({})) {
        names.push_back(command->get_name());
        cases += command_cases(*command, command->get_name(), choices);
    }
    cases += command_cases(program, "", choices);
    return fmt::format(
        script, fmt::arg("program", program.get_name()),
        fmt::arg("function", function_name(program)),
        fmt::arg("commands", names.empty() ? "\"\"" : fmt::format("{}", fmt::join(names, " | "))),
        fmt::arg("cases", cases));
}

}  // namespace etalon
