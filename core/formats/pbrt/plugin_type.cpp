#include "core/formats/pbrt/plugin_type.h"

#include <algorithm>

#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

struct CategoryEntry {
    std::string_view name;
    std::span<const PluginType> (*types)();
};

// In the order of Category.
constexpr std::array<CategoryEntry, category_count> categories = {{
    {"camera", camera_types},
    {"sampler", sampler_types},
    {"film", film_types},
    {"filter", filter_types},
    {"integrator", integrator_types},
    {"accelerator", accelerator_types},
    {"shape", shape_types},
    {"material", material_types},
    {"float texture", float_texture_types},
    {"spectrum texture", spectrum_texture_types},
    {"light", light_types},
    {"area light", area_light_types},
    {"medium", medium_types},
}};

struct TypeEntry {
    std::string_view name;
    int components;
};

// In the order of ValueType.
constexpr std::array<TypeEntry, 12> value_types = {{{"float", 1},
                                                    {"integer", 1},
                                                    {"bool", 1},
                                                    {"string", 1},
                                                    {"string", 1},
                                                    {"string", 1},
                                                    {"rgb", 3},
                                                    {"point2", 2},
                                                    {"vector2", 2},
                                                    {"point", 3},
                                                    {"vector", 3},
                                                    {"normal", 3}}};

const CategoryEntry& entry(Category category) {
    return categories[static_cast<std::size_t>(category)];
}

const TypeEntry& entry(ValueType type) {
    return value_types[static_cast<std::size_t>(type)];
}

}  // namespace

const ParameterSpec* PluginType::find(std::string_view parameter) const {
    const auto found = std::ranges::find(parameters, parameter, &ParameterSpec::name);
    return found != parameters.end() ? &*found : nullptr;
}

std::span<const PluginType> plugin_types(Category category) {
    return entry(category).types();
}

const PluginType* find_plugin(Category category, std::string_view name) {
    for (const PluginType& type : plugin_types(category)) {
        const bool is_alias = !type.alias.empty() && name == type.alias;
        if (name == type.name || is_alias) return &type;
    }
    return nullptr;
}

std::string_view to_string(Category category) {
    return entry(category).name;
}

std::string_view to_string(ValueType type) {
    return entry(type).name;
}

int components(ValueType type) {
    return entry(type).components;
}

}  // namespace etalon::pbrt
