#include "core/formats/pbrt/binder.h"

#include <algorithm>
#include <cmath>

#include "core/formats/diagnostic_log.h"
#include "core/formats/nearest_name.h"

namespace etalon::pbrt {
namespace {

/// Length from which lists are moved, not copied; shorter ones may be needed again.
constexpr std::size_t longest_copied = 16;

bool contains(std::string_view choices, std::string_view text) {
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find('|'), choices.size());
        if (choices.substr(0, end) == text) return true;
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return false;
}

/// Type under which files give the values of a parameter.
ValueType given_type(ValueType type) {
    const bool is_name = type == ValueType::file || type == ValueType::material;
    return is_name ? ValueType::string : type;
}

template <class T>
void keep_first(std::vector<T>& values, std::size_t count) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(count), values.end());
}

/// Keeps the first of several values, each of `width` numbers.
void keep_first(Values& values, std::size_t width) {
    if (auto* n = std::get_if<std::vector<float>>(&values)) keep_first(*n, width);
}

struct Copied {
    template <class T>
    Values operator()(std::vector<T>& values) const {
        if (values.size() > longest_copied) return std::move(values);
        return values;
    }
};

}  // namespace

std::optional<std::vector<Argument>> Binder::bind(const PluginType& type,
                                                  std::span<ParameterList* const> lists,
                                                  FileLoc where) {
    std::vector<Argument> arguments;
    for (const ParameterSpec& spec : type.parameters) {
        if (std::optional<Values> values = find(spec, lists)) {
            arguments.push_back({&spec, std::move(*values)});
        } else if (spec.is_required) {
            log_.error(where, "missing", "the {} '{}' is left out: '{} {}' is missing",
                       to_string(type.category), type.name, to_string(spec.type), spec.name);
            return std::nullopt;
        }
    }
    return arguments;
}

std::optional<Values> Binder::find(const ParameterSpec& spec,
                                   std::span<ParameterList* const> lists) {
    const auto in_lists = [&](const Spelling& spelling) {
        for (ParameterList* list : lists) {
            GivenParameter* const named =
                spec.slot == Slot::texture ? list->find_texture(spelling.name) : nullptr;
            if (named) return texture(spec, *named);
            if (std::optional<Values> v = find(spec, spelling, *list)) return v;
        }
        return std::optional<Values>();
    };
    if (std::optional<Values> v = in_lists({spec.name, spec.type})) return v;
    for (const Spelling& other : spec.other_spellings()) {
        if (std::optional<Values> v = in_lists(other)) return v;
    }
    return std::nullopt;
}

std::optional<Values> Binder::find(const ParameterSpec& spec, const Spelling& spelling,
                                   ParameterList& list) {
    const std::string_view name = spelling.name;
    GivenParameter* const given = list.find(name, given_type(spelling.type));
    if (!given) return std::nullopt;
    given->is_used = true;
    if (!is_usable(spec, *given)) return std::nullopt;
    const std::size_t several = given->count();
    Values values = convert(spec, *given);
    if (spec.slot == Slot::texture && several > 1) {
        log_.warn(given->where, "count", "'{}' takes one value; {} more are ignored", name,
                  several - 1);
        keep_first(values, static_cast<std::size_t>(components(spec.type)));
    }
    if (!is_accepted(spec, values, given->where)) return std::nullopt;
    return values;
}

std::optional<Values> Binder::texture(const ParameterSpec& spec, GivenParameter& given) {
    given.is_used = true;
    const bool of_spectra = spec.type == ValueType::color;
    const auto& names = of_spectra ? textures_.spectra : textures_.numbers;
    const std::string& name = std::get<std::vector<std::string>>(given.values).front();
    if (const std::uint32_t* number = names.find(name)) return TextureNumber{*number};
    log_.error(
        given.where, "undefined", "no {} texture {} is defined for '{}'{}",
        of_spectra ? "spectrum" : "float", in_quotes(name), given.name,
        log_.hint(Severity::error, "undefined", [&] { return did_you_mean(name, names.names()); }));
    return std::nullopt;
}

bool Binder::is_usable(const ParameterSpec& spec, const GivenParameter& given) {
    const bool may_be_infinite = spec.default_value.numbers[0] > 1e38F;
    if (given.not_finite.line != 0 && !may_be_infinite) {
        log_.error(given.not_finite, "range",
                   "a number of '{}' is not finite, or too large; "
                   "the parameter is left out",
                   given.name);
        return false;
    }
    return has_right_count(spec, given);
}

bool Binder::has_right_count(const ParameterSpec& spec, const GivenParameter& given) {
    const std::size_t count = given.count();
    if ((spec.slot == Slot::one || spec.length == 1) && count != 1) {
        log_.warn(given.where, "count", "'{}' is not used: it takes one value, not {}", given.name,
                  count);
        return false;
    }
    if (spec.length != 0 && count != spec.length) {
        log_.error(given.where, "count", "'{}' is not used: it takes {} values, not {}", given.name,
                   spec.length, count);
        return false;
    }
    return count != 0;
}

/// Copies or moves the values, as the type in the table.
Values Binder::convert(const ParameterSpec& spec, GivenParameter& given) {
    Values values = std::visit(Copied{}, given.values);
    if (spec.type == ValueType::file) {
        std::string& name = std::get<std::vector<std::string>>(values).front();
        name = tokens_.resolve(name, given.where).value_or(std::string());
    } else if (spec.type == ValueType::integer && given.type == ValueType::number) {
        const float x = std::get<std::vector<float>>(values).front();
        values = std::vector{static_cast<std::int32_t>(std::clamp(x, -1e9F, 1e9F))};
    } else if (auto* numbers = std::get_if<std::vector<float>>(&values)) {
        const auto width = static_cast<std::size_t>(components(spec.type));
        numbers->resize(numbers->size() - numbers->size() % width);
    }
    return values;
}

bool Binder::is_accepted(const ParameterSpec& spec, Values& values, FileLoc where) {
    if (spec.choices.empty()) return true;
    std::string& text = std::get<std::vector<std::string>>(values).front();
    if (contains(spec.choices, text)) return true;
    std::string list(spec.choices);
    std::ranges::replace(list, '|', ' ');
    const bool has_own = !spec.if_unknown.empty();
    const std::string_view instead = has_own ? spec.if_unknown : spec.default_value.text;
    log_.error(where, "choice", "unknown '{}' {}; it is '{}' instead; there are: {}", spec.name,
               in_quotes(text), instead, list);
    text = instead;
    return has_own;
}

}  // namespace etalon::pbrt
