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

/// Returns whether a parameter takes a value that is given so: another one was used instead.
bool takes(const ParameterSpec& spec, const GivenParameter& given) {
    if (given.is_texture) return spec.slot == Slot::texture;
    const auto fits = [&](const Spelling& spelling) {
        return spelling.name == given.name && to_string(spelling.type) == to_string(given.type);
    };
    return fits({spec.name, spec.type}) || std::ranges::any_of(spec.other_spellings(), fits);
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
        const ParameterSpec* const spec = find_by_any_name(type, given.name);
        if (spec && takes(*spec, given)) {
            log.warn(given.where, "unused", "'{} {}' is not used beside another value of '{}'",
                     given.type_word, given.name, spec->name);
        } else if (spec) {
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
