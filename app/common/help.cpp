#include "app/common/help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "app/common/option_text.h"

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
        std::string text = "Usage: " + usage_of(*app, name) + "\n\n";
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
