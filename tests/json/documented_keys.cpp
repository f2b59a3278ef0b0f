#include "tests/json/documented_keys.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace etalon::test {
namespace {

std::string anchor_of(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        const auto u = static_cast<unsigned char>(c);
        if (std::isalnum(u) || c == '-') anchor += static_cast<char>(std::tolower(u));
        if (c == ' ') anchor += '-';
    }
    return anchor;
}

std::vector<std::string> matches_in(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> all;
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
        all.push_back((*i)[1]);
    }
    return all;
}

/// "| `a`, `b` | type | unit | meaning |"
void add_rows(const std::string& line, DocumentedSection& section) {
    static const std::regex row(R"(\| ([^|]*) \| ([^|]+) \|[^|]*\|[^|]*\|)"), name("`([^`]+)`");
    std::smatch cells;
    if (!std::regex_match(line, cells, row)) throw std::runtime_error("no row of keys: " + line);
    for (const std::string& key : matches_in(cells[1], name)) {
        section.rows.push_back({key, cells[2]});
    }
}

Path path_of(const std::string& key) {
    Path path;
    std::istringstream names(key);
    for (std::string name; std::getline(names, name, '.');) {
        const bool is_list = name.ends_with("[]");
        path.push_back(is_list ? name.substr(0, name.size() - 2) : name);
        if (is_list) path.emplace_back("[]");
    }
    return path;
}

/// Collects the patterns of the sections below a path.
class Expansion {
  public:
    explicit Expansion(const DocumentedSections& sections) : sections_(sections) {}

    void add_section(const Path& place, const std::string& name) {
        const auto found = sections_.find(name);
        if (found == sections_.end()) throw std::runtime_error("no section " + name);
        for (const std::string& included : found->second.includes) add_section(place, included);
        for (const auto& [key, type] : found->second.rows) {
            Path path = place;
            std::ranges::copy(path_of(key), std::back_inserter(path));
            add_type(path, type, name + ": " + key);
        }
    }

    std::vector<Pattern> patterns;

  private:
    /// "number", "string or null", "list of integer", "list of (number or null)", "[Name](#name)"
    void add_type(Path path, const std::string& type, const std::string& line) {
        static const std::regex list(R"(list of (\[.*\]\(.*\)|\w+|\(.*\))( or null)?)"),
            link(R"(\[.*\]\(#(.*)\))"), name("integer|number|string|boolean|null"),
            alternatives(R"((\w+) or (\w+)|\((.*)\))");
        std::smatch part;
        if (std::regex_match(type, part, list)) {
            if (part[2].matched) add_type(path, "null", line);
            path.emplace_back("[]");
            add_type(path, part[1], line);
        } else if (std::regex_match(type, part, link)) {
            patterns.push_back({path, "object", line + " (object)"});
            add_section(path, part[1]);
        } else if (std::regex_match(type, name)) {
            patterns.push_back({path, type, line + " (" + type + ")"});
        } else if (std::regex_match(type, part, alternatives)) {
            if (part[3].matched) return add_type(path, part[3], line);
            add_type(path, part[1], line);
            add_type(path, part[2], line);
        } else {
            throw std::runtime_error(line + ": no type: " + type);
        }
    }

    const DocumentedSections& sections_;
};

}  // namespace

DocumentedSections read_sections(const std::string& markdown) {
    static const std::regex included(R"(The keys of \[.*?\]\(#(.*?)\))");
    DocumentedSections sections;
    DocumentedSection* section = nullptr;
    std::istringstream lines(markdown);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) section = &sections[anchor_of(line.substr(3))];
        if (section == nullptr) continue;
        for (const std::string& name : matches_in(line, included)) {
            section->includes.push_back(name);
        }
        if (line.starts_with("| `")) add_rows(line, *section);
    }
    return sections;
}

std::vector<Pattern> patterns_of(const DocumentedSections& sections, const std::string& section) {
    Expansion expansion(sections);
    expansion.add_section({}, section);
    return std::move(expansion.patterns);
}

}  // namespace etalon::test
