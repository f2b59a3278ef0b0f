#include "bench/table/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "bench/table/columns.h"

namespace etalon::table {
namespace {

/// Returns the words after `beginning`; further lines are indented by its length.
std::string wrapped(const std::string& beginning, const std::string& words) {
    std::string text, line = beginning;
    std::istringstream stream(words);
    for (std::string word; stream >> word;) {
        if (line.size() + 1 + word.size() > line_width) {
            text += line + "\n";
            line = std::string(beginning.size(), ' ');
        }
        line += " " + word;
    }
    return text + line + "\n";
}

}  // namespace

std::string without_trailing_blanks(const std::string& text) {
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

std::string whole_name(const std::string& above, const std::string& name) {
    if (above.empty() || name.empty()) return above + name;
    if (above.ends_with('-')) return above.substr(0, above.size() - 1) + name;
    return above + " " + name;
}

void Legend::add(const std::string& name, const std::string& meaning) {
    const std::pair entry(name, meaning);
    if (!meaning.empty() && std::ranges::find(entries_, entry) == entries_.end()) {
        entries_.push_back(entry);
    }
}

std::string Legend::text() const {
    std::size_t longest = 0;
    for (const auto& [name, meaning] : entries_) longest = std::max(longest, name.size());
    std::string text;
    for (const auto& [name, meaning] : entries_) {
        text += wrapped(fmt::format("  {:{}} ", name, longest), meaning);
    }
    return text;
}

}  // namespace etalon::table
