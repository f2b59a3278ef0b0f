#include "app/common/man_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "app/common/option_text.h"
#include "app/common/program_facts.h"

namespace etalon {
namespace {

/// Returns text with roff's commands escaped; its "-" can be copied to a command line.
std::string literal(std::string_view text) {
    std::string roff;
    if (text.starts_with('.') || text.starts_with('\'')) roff = "\\&";
    for (const char c : text) {
        if (c == '\\') {
            roff += "\\e";
        } else if (c == '-') {
            roff += "\\-";
        } else {
            roff += c;
        }
    }
    return roff;
}

std::string upper_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// Returns "render a scene", as in the index line of a manual.
std::string index_line(std::string description) {
    description[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(description[0])));
    return literal(description);
}

std::string page_name(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

/// Returns "-o, --output FILE" with the names of the option bold, and that of its value in italics.
std::string highlighted(const std::string& name) {
    std::istringstream words(name);
    std::string roff;
    for (std::string word; words >> word;) {
        const bool more = word.ends_with(',');
        if (more) word.pop_back();
        roff += fmt::format("{}\\f{}{}\\fR{}", roff.empty() ? "" : " ",
                            word.starts_with('-') ? 'B' : 'I', literal(word), more ? "," : "");
    }
    return roff;
}

std::string entry(const std::string& term, const std::string& description) {
    return fmt::format(".TP\n{}\n{}\n", term, literal(description));
}

std::string see(const std::string& page) {
    return fmt::format("\\fB{}\\fR(1)", literal(page));
}

template <class Test>
std::string entries(const CLI::App& command, const Test& belongs) {
    std::string roff;
    for (const CLI::Option* option : command.get_options(belongs)) {
        roff += entry(highlighted(name_of(*option)), description_of(*option));
    }
    return roff;
}

std::string positionals(const CLI::App& command) {
    return entries(command, [](const auto* o) { return o->get_positional(); });
}

/// Returns the options, under the headings of the help.
std::string options(const CLI::App& command) {
    std::string roff;
    for (const std::string& group : command.get_groups()) {
        const std::string all = entries(
            command, [&](const auto* o) { return o->get_group() == group && o->nonpositional(); });
        if (all.empty()) continue;
        roff += group == "Options" ? ".SH OPTIONS\n" : fmt::format(".SS {}\n", literal(group));
        roff += all;
    }
    return roff;
}

std::string commands(const CLI::App& program, const std::string& name) {
    std::string roff;
    for (const CLI::App* command : program.get_subcommands({})) {
        roff += entry(see(page_name(name + " " + command->get_name())), command->get_description());
    }
    return roff.empty() ? roff : ".SH COMMANDS\n" + roff;
}

/// Returns text whose indented lines, and all that follow, remain lines; without the page's own
/// indentation if they would not fit beside it.
std::string body_text(const std::string& text) {
    std::istringstream lines(text);
    std::string roff;
    std::size_t widest = 0;
    bool indented = false;
    for (std::string line; std::getline(lines, line);) {
        widest = std::max(widest, line.size());
        indented = indented || line.starts_with(' ');
        if (!line.empty()) roff += literal(line) + "\n";
    }
    if (!indented) return roff;
    if (widest > 72) roff = ".in 0\n" + roff + ".in\n";
    return ".nf\n" + roff + ".fi\n";
}

/// Returns a paragraph that begins with a heading, "Examples:" or "Exit status: 0 done", as a
/// section.
std::string closing_section(std::string_view paragraph) {
    const std::size_t end = std::min(paragraph.find_first_of(":("), paragraph.size());
    std::string heading(paragraph.substr(0, end));
    heading.erase(heading.find_last_not_of(' ') + 1);
    const std::size_t body = std::min(paragraph.find_first_not_of(": ", end), paragraph.size());
    return fmt::format(".SH {}\n", literal(upper_case(heading))) +
           body_text(std::string(paragraph.substr(body)));
}

/// Returns the end of the help, paragraph by paragraph.
std::string closing_sections(std::string_view footer) {
    std::string roff;
    while (!footer.empty()) {
        const std::size_t end = std::min(footer.find("\n\n"), footer.size());
        roff += closing_section(footer.substr(0, end));
        footer.remove_prefix(std::min(end + 2, footer.size()));
    }
    return roff;
}

/// Returns references to the page of the program, or to those of its subcommands.
std::string see_also(const CLI::App& command, const std::string& name) {
    const CLI::App* const program = command.get_parent() ? command.get_parent() : &command;
    std::vector<std::string> pages;
    if (program != &command) pages.push_back(program->get_name());
    for (const CLI::App* other : program->get_subcommands({})) {
        pages.push_back(program->get_name() + "-" + other->get_name());
    }
    std::erase(pages, page_name(name));
    std::string roff;
    for (const std::string& page : pages) roff += (roff.empty() ? "" : ",\n") + see(page);
    return roff.empty() ? roff : ".SH SEE ALSO\n" + roff + "\n";
}

}  // namespace

/// Disables hyphenation and justification, so that names of options are not broken.
std::string man_page(const CLI::App& command, const std::string& name) {
    const std::string page = page_name(name);
    return fmt::format(".TH {} 1 \"\" \"Etalon {}\" \"Etalon Manual\"\n.nh\n.ad l\n",
                       literal(upper_case(page)), build_facts().version) +
           fmt::format(".SH NAME\n{} \\- {}\n", literal(page),
                       index_line(command.get_description())) +
           fmt::format(".SH SYNOPSIS\n{}\n", literal(usage_of(command, name))) +
           fmt::format(".SH DESCRIPTION\n{}.\n", literal(command.get_description())) +
           positionals(command) + commands(command, name) + options(command) +
           closing_sections(command.get_footer()) + see_also(command, name);
}

}  // namespace etalon
