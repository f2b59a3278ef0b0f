#include "app/render/filter_option.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/base/parse_number.h"
#include "core/formats/nearest_name.h"

namespace etalon {
namespace {

/// The parts before and after the colon.
struct FilterText {
    std::string name;
    std::optional<std::string> radius;

    explicit FilterText(const std::string& text) : name(text.substr(0, text.find(':'))) {
        if (name.size() < text.size()) radius = text.substr(name.size() + 1);
    }
};

const FilterType* find_filter(const std::string& name) {
    const auto found = std::ranges::find(filter_list, name, &FilterType::name);
    return found == filter_list.end() ? nullptr : &*found;
}

/// Returns the radius in the text, or 0.
double radius_of(const std::string& text) {
    const double radius = parse_number<double>(text).value_or(0);
    return radius > 0 && radius <= max_filter_radius ? radius : 0;
}

}  // namespace

std::vector<std::string> filter_names() {
    std::vector<std::string> names(filter_list.size());
    std::ranges::transform(filter_list, names.begin(), &FilterType::name);
    return names;
}

std::string filter_help() {
    std::string text = "Reconstruction filter, and its radius in pixels (default: the scene's)";
    for (const FilterType& type : filter_list) {
        text += fmt::format("{} {}:{}", type.kind == FilterKind::box ? ";" : ",", type.name,
                            type.radius);
    }
    return text;
}

std::string check_filter(const std::string& text) {
    const FilterText parts(text);
    if (!find_filter(parts.name)) {
        const std::vector<std::string> all = filter_names();
        const std::vector<std::string_view> names(all.begin(), all.end());
        return fmt::format("{}: expected one of {}{}", text, fmt::join(names, ", "),
                           did_you_mean(parts.name, names));
    }
    if (!parts.radius || radius_of(*parts.radius) > 0) return {};
    return fmt::format("{}: expected a radius above 0 and at most {} pixels after the colon", text,
                       max_filter_radius);
}

void apply_filter(const std::string& text, PixelFilter& filter) {
    const FilterText parts(text);
    const FilterType& type = *find_filter(parts.name);
    filter = {type.kind, Vec2(parts.radius ? radius_of(*parts.radius) : type.radius)};
}

}  // namespace etalon
