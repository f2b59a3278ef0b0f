#include "bench/hard_cases/case_names.h"

#include <algorithm>

#include "app/common/joined_words.h"

namespace etalon::hard {
namespace {

bool is_named(const HardCase& c, const std::string& name) {
    const bool is_variant = name.find('/') != std::string::npos;
    return name == c.id || c.id.starts_with(name + '-') ||
           (is_variant && (c.id + '/' + c.variant).starts_with(name));
}

bool is_any(const std::vector<HardCase>& cases, const std::string& name) {
    return std::ranges::any_of(cases, [&](const HardCase& c) { return is_named(c, name); });
}

}  // namespace

Result<std::vector<HardCase>> cases_named(const std::vector<std::string>& words) {
    std::vector<HardCase> cases = hard_cases();
    if (words.empty()) return {std::move(cases), {}};
    const std::vector<std::string> names =
        joined_words(words, [&](const std::string& name) { return is_any(cases, name); });
    for (const std::string& name : names) {
        if (!is_any(cases, name))
            return {{}, name + ": no case of that name; --list shows them all"};
    }
    std::erase_if(cases, [&](const HardCase& c) {
        return std::ranges::none_of(names, [&](const auto& name) { return is_named(c, name); });
    });
    return {std::move(cases), {}};
}

}  // namespace etalon::hard
