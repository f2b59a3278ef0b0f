#include "app/common/completion_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace etalon {

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

/// The help hides an option by giving it no group.
std::vector<const CLI::Option*> named_options(const CLI::App& command) {
    return command.get_options(
        [](const CLI::Option* o) { return !o->get_group().empty() && !o->get_positional(); });
}

std::vector<std::string> plain_words(const CLI::App& command, const ValueChoices& choices) {
    std::vector<std::string> words;
    for (const CLI::App* sub : command.get_subcommands({})) words.push_back(sub->get_name());
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_positional()) continue;
        const std::vector<std::string> known = values_of(*option, choices);
        words.insert(words.end(), known.begin(), known.end());
    }
    return words;
}

std::vector<std::string> values_of(const CLI::Option& option, const ValueChoices& choices) {
    const auto known = choices.find(&option);
    return known == choices.end() ? std::vector<std::string>() : known->second;
}

bool is_list(const CLI::Option& option) {
    return option.get_delimiter() == ',';
}

std::string summary_of(const CLI::Option& option) {
    std::string text = option.get_description();
    for (const char* end : {" (", "; ", ". "}) text.resize(std::min(text.find(end), text.size()));
    return text;
}

}  // namespace etalon
