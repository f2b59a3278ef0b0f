#include "core/formats/pbrt/parser.h"

#include <fmt/ranges.h>

#include "core/formats/diagnostic_log.h"
#include "core/formats/nearest_name.h"
#include "core/formats/pbrt/foreign_words.h"
#include "core/formats/pbrt/unused_parameters.h"

namespace etalon::pbrt {
namespace {

std::vector<std::string_view> names_of(Category category) {
    std::vector<std::string_view> names;
    for (const PluginType& type : plugin_types(category)) names.push_back(type.name);
    return names;
}

/// Where an unknown plugin comes from, as far as is known, and what may have been meant instead.
struct Hints {
    std::string origin, meant;
};

Hints hints_on(Category category, const std::string& name) {
    if (const auto origin = origin_of_plugin(category, name); !origin.empty())
        return {fmt::format(", which is of {}", origin), {}};
    const auto names = names_of(category);
    const std::string near = did_you_mean(name, names);
    return {{}, near.empty() ? fmt::format("; there are: {}", fmt::join(names, " ")) : near};
}

}  // namespace

const PluginType* Parser::find_type(Category category, const std::string& name, Unknown unknown) {
    if (const PluginType* type = find_plugin(category, name)) return type;
    const auto severity =
        unknown.grade == Unknown::Grade::warning ? Severity::warning : Severity::error;
    const Hints hints = log.hint(severity, "unknown", [&] { return hints_on(category, name); });
    const std::string text =
        fmt::format("unknown {} {}{}; {}{}", to_string(category), in_quotes(name), hints.origin,
                    unknown.consequence, hints.meant);
    if (unknown.grade == Unknown::Grade::warning) log.warn(in.where(), "unknown", "{}", text);
    if (unknown.grade == Unknown::Grade::error) log.error(in.where(), "unknown", "{}", text);
    if (unknown.grade == Unknown::Grade::fatal) log.fatal(in.where(), "unknown", "{}", text);
    return nullptr;
}

std::string Parser::take_type(ParameterList& list) {
    GivenParameter* const type = list.find("type", ValueType::string);
    if (type && type->count() == 1) {
        type->is_used = true;
        return std::get<std::vector<std::string>>(type->values).front();
    }
    log.error(in.where(), "missing", "'{}' has no \"string type\"", in.directive());
    return {};
}

std::optional<Plugin> Parser::make_plugin(const PluginType& type, ParameterList& list) {
    ParameterList* const lists[] = {&list};
    std::optional<std::vector<Argument>> arguments = binder().bind(type, lists, in.where());
    report_unused(list, type, log);
    if (!arguments) return std::nullopt;
    Plugin plugin(type, std::move(*arguments), in.where());
    return check(plugin) ? std::optional(std::move(plugin)) : std::nullopt;
}

bool Parser::check(const Plugin& plugin) {
    const auto incompatibility =
        plugin.type->check ? plugin.type->check(plugin.parameters) : std::nullopt;
    if (!incompatibility) return true;
    if (incompatibility->leaves_out) {
        log.error(plugin.where, "unfit", "the {} '{}' is left out: {}",
                  to_string(plugin.type->category), plugin.type->name, incompatibility->text);
    } else {
        log.warn(plugin.where, "unfit", "{}", incompatibility->text);
    }
    return !incompatibility->leaves_out;
}

TransformPair Parser::transform_pair() {
    TransformState& t = *now.transform.current;
    if (!t.numbers) {
        TransformList& list = frame().transforms;
        const std::uint32_t start = list.add(t.start());
        t.numbers = {start, t.is_animated() ? list.add(t.end()) : start};
    }
    return *t.numbers;
}

std::uint32_t Parser::start_transform() {
    if (now.transform.current->is_animated()) {
        log.warn(in.where(), "animated", "'{}' cannot move: it stays where it is at the start",
                 in.directive());
    }
    return transform_pair().start;
}

MediumInterface Parser::current_media(FileLoc where) {
    MediumInterface media;
    if (!now.graphics.media) return media;
    const auto number_of = [&](const std::string& name) {
        if (name.empty()) return none;
        const auto found = now.media.find(name);
        if (found != now.media.end()) return found->second;
        log.error(where, "undefined", "no medium {} is defined", in_quotes(name));
        return none;
    };
    media.inside = number_of((*now.graphics.media)[0]);
    media.outside = number_of((*now.graphics.media)[1]);
    return media;
}

}  // namespace etalon::pbrt
