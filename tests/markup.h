#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace etalon::test {

/// Returns how often `part` occurs in the text.
inline std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
    return n;
}

/// Returns whether every tag that is opened is closed, in order, every "&" begins an entity, and
/// every "<" a tag. For XML, and for HTML as the project writes it, where elements without an end
/// tag have none.
inline bool is_well_formed(const std::string& markup) {
    const std::vector<std::string_view> entities{"amp", "lt", "gt", "quot"};
    const std::vector<std::string_view> empty{"!DOCTYPE", "meta", "link", "img"};
    const auto has = [](const auto& list, std::string_view name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    std::vector<std::string> open;
    for (std::size_t at = 0; (at = markup.find_first_of("<&", at)) != std::string::npos; ++at) {
        const bool is_entity = markup[at] == '&';
        const std::size_t end = markup.find_first_of(is_entity ? ";" : ">", at);
        if (end == std::string::npos) return false;
        const std::string inside = markup.substr(at + 1, end - at - 1);
        if (inside.find('<') != std::string::npos) return false;
        const std::string name = inside.substr(0, inside.find(' '));
        if (is_entity) {
            if (!has(entities, inside)) return false;
        } else if (inside.starts_with("/")) {
            if (open.empty() || open.back() != inside.substr(1)) return false;
            open.pop_back();
        } else if (!inside.ends_with("/") && !has(empty, name)) {
            open.push_back(name);
        }
    }
    return open.empty();
}

}  // namespace etalon::test
