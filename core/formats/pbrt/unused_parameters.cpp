#include "core/formats/pbrt/unused_parameters.h"

#include <algorithm>

#include "core/formats/diagnostic_log.h"
#include "core/formats/nearest_name.h"

namespace etalon::pbrt {
namespace {

const ParameterSpec* find_by_any_name(const PluginType& type, std::string_view name) {
    const auto has = [&](const ParameterSpec& spec) {
        const auto others = spec.other_spellings();
        return spec.name == name ||
               std::ranges::find(others, name, &Spelling::name) != others.end();
    };
    const auto found = std::ranges::find_if(type.parameters, has);
    return found != type.parameters.end() ? &*found : nullptr;
}

/// Returns the types that a parameter takes, in words: "float or texture".
std::string accepted_types(const ParameterSpec& spec) {
    const std::string_view own = to_string(spec.type);
    return spec.slot == Slot::texture ? fmt::format("{} or texture", own) : std::string(own);
}

std::vector<std::string_view> names(const PluginType& type) {
    std::vector<std::string_view> list;
    for (const ParameterSpec& spec : type.parameters) list.push_back(spec.name);
    return list;
}

}  // namespace

void report_unused(const ParameterList& list, const PluginType& type, Log& log) {
    for (const GivenParameter& given : list.parameters) {
        if (given.is_used) continue;
        if (const ParameterSpec* spec = find_by_any_name(type, given.name)) {
            log.warn(given.where, "unused", "'{} {}' is not used: in the {} '{}' its type is {}",
                     given.type_word, given.name, to_string(type.category), type.name,
                     accepted_types(*spec));
        } else {
            log.warn(given.where, "unused", "{} is not used: the {} '{}' has no such parameter{}",
                     in_quotes(given.name), to_string(type.category), type.name,
                     log.hint(Severity::warning, "unused",
                              [&] { return did_you_mean(given.name, names(type)); }));
        }
    }
}

}  // namespace etalon::pbrt
