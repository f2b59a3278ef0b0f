#include "app/common/help.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

namespace etalon {
namespace {

constexpr std::size_t line_width = 80, name_width = 28;

/// Appends words to a text whose last line is `at` columns long, each line after it indented.
void append_wrapped(std::string& text, std::string_view words, std::size_t at, std::size_t indent) {
    bool first = true;
    while (!words.empty()) {
        const std::string_view word = words.substr(0, words.find(' '));
        words.remove_prefix(std::min(word.size() + 1, words.size()));
        const std::size_t blank = first ? 0 : 1;
        if (!first && at + blank + word.size() > line_width) {
            text += '\n' + std::string(indent, ' ');
            at = indent;
        } else {
            text.append(blank, ' ');
            at += blank;
        }
        text += word;
        at += word.size();
        first = false;
    }
    text += '\n';
}

/// "-o, --output FILE", or "SCENE...".
std::string name_of(const CLI::Option& option) {
    if (option.get_positional()) {
        return option.get_name(true) + (option.get_expected_max() > 1 ? "..." : "");
    }
    std::string names;
    for (const std::string& name : option.get_snames()) names += "-" + name + ", ";
    for (const std::string& name : option.get_lnames()) names += "--" + name + ", ";
    names.resize(names.size() - 2);
    const bool has_value = option.get_type_size_max() > 0;
    return has_value ? names + " " + option.get_type_name() : names;
}

/// "[a,b]", as CLI11 shows a list, as "a, b".
std::string spaced(const std::string& value) {
    std::string text;
    for (const char c : value) {
        if (c == ',') text += ", ";
        if (c != ',' && c != '[' && c != ']') text += c;
    }
    return text;
}

std::string description_of(const CLI::Option& option) {
    std::string text = option.get_description();
    std::vector<std::string> others;
    for (const CLI::Option* other : option.get_excludes()) others.push_back(other->get_name());
    if (!others.empty()) text += fmt::format(". Not with {}", fmt::join(others, " or "));
    const std::string value = option.get_default_str();
    return value.empty() ? text : fmt::format("{}. Default: {}", text, spaced(value));
}

std::string usage(const CLI::App& app, const std::string& name) {
    std::string text = "Usage: " + name;
    const auto positionals = app.get_options([](const auto* o) { return o->get_positional(); });
    if (!app.get_subcommands({}).empty()) text += " COMMAND";
    text += " [OPTIONS]";
    for (const CLI::Option* option : positionals) text += " " + name_of(*option);
    return text + "\n";
}

template <class Test>
std::string section(const std::string& heading, const CLI::App& app, const Test& belongs) {
    std::string text;
    for (const CLI::Option* option : app.get_options(belongs)) {
        text += help_entry(name_of(*option), description_of(*option));
    }
    return text.empty() ? text : "\n" + heading + text;
}

std::string commands(const CLI::App& app) {
    std::string text;
    for (const CLI::App* command : app.get_subcommands({})) {
        text += help_entry(command->get_name(), command->get_description());
    }
    return text.empty() ? text : "\nCommands:\n" + text;
}

class HelpFormatter : public CLI::FormatterBase {
  public:
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode /*mode*/) const override {
        std::string text = usage(*app, name) + "\n";
        append_wrapped(text, app->get_description(), 0, 0);
        text += section("", *app, [](const auto* o) { return o->get_positional(); });
        for (const std::string& group : app->get_groups()) {
            text += section(group + ":\n", *app, [&](const auto* o) {
                return o->get_group() == group && o->nonpositional();
            });
        }
        return text + commands(*app) + "\n" + app->get_footer();
    }
};

}  // namespace

std::string help_entry(const std::string& name, const std::string& description) {
    std::string text = "  " + name;
    const std::size_t pad =
        text.size() + 2 > name_width ? (text += '\n', name_width) : name_width - text.size();
    text.append(pad, ' ');
    append_wrapped(text, description, name_width, name_width);
    return text;
}

std::shared_ptr<CLI::FormatterBase> help_formatter() {
    return std::make_shared<HelpFormatter>();
}

}  // namespace etalon
