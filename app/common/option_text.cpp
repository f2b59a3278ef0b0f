#include "app/common/option_text.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

namespace etalon {
namespace {

/// "[a,b]", as CLI11 shows a list, as "a, b".
std::string spaced(const std::string& value) {
    std::string text;
    for (const char c : value) {
        if (c == ',') text += ", ";
        if (c != ',' && c != '[' && c != ']') text += c;
    }
    return text;
}

}  // namespace

bool has_value(const CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

std::string name_of(const CLI::Option& option) {
    if (option.get_positional()) {
        return option.get_name(true) + (option.get_expected_max() > 1 ? "..." : "");
    }
    std::string names;
    for (const std::string& name : option.get_snames()) names += "-" + name + ", ";
    for (const std::string& name : option.get_lnames()) names += "--" + name + ", ";
    names.resize(names.size() - 2);
    return has_value(option) ? names + " " + option.get_type_name() : names;
}

std::string description_of(const CLI::Option& option) {
    std::string text = option.get_description();
    std::vector<std::string> others;
    for (const CLI::Option* other : option.get_excludes()) others.push_back(other->get_name());
    if (!others.empty()) text += fmt::format(". Not with {}", fmt::join(others, " or "));
    const std::string value = option.get_default_str();
    return value.empty() ? text : fmt::format("{} (default: {})", text, spaced(value));
}

std::string usage_of(const CLI::App& command, const std::string& name) {
    std::string text = name;
    const auto positionals = command.get_options([](const auto* o) { return o->get_positional(); });
    if (!command.get_subcommands({}).empty()) text += " COMMAND";
    text += " [OPTIONS]";
    for (const CLI::Option* option : positionals) {
        const std::string argument = name_of(*option);
        text += option->get_required() ? " " + argument : " [" + argument + "]";
    }
    return text;
}

}  // namespace etalon
