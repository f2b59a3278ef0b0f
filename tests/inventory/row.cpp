#include "tests/inventory/row.h"

#include <fmt/format.h>

#include <cmath>

namespace etalon::test {
namespace {

constexpr std::span<const Row> (*tables[])() = {
    camera_rows,      sampler_rows,    film_rows,     filter_rows,        integrator_rows,
    accelerator_rows, shape_rows,      material_rows, float_texture_rows, spectrum_texture_rows,
    light_rows,       area_light_rows, medium_rows};
static_assert(std::size(tables) == pbrt::category_count);

}  // namespace

std::span<const Row> rows_of(pbrt::Category category) {
    return tables[static_cast<std::size_t>(category)]();
}

const Row* find_row(const pbrt::PluginType& plugin, std::string_view parameter) {
    const Row* found = nullptr;
    for (const Row& row : rows_of(plugin.category)) {
        if (row.parameter != parameter) continue;
        if (row.plugin == plugin.name) return &row;
        if (row.plugin == "*") found = &row;
    }
    return found;
}

std::string default_of(const pbrt::ParameterSpec& spec) {
    if (spec.type == pbrt::ValueType::flag && spec.default_value.count > 0) {
        return spec.default_value.numbers[0] != 0 ? "true" : "false";
    }
    std::string text(spec.default_value.text);
    for (std::size_t i = 0; i < spec.default_value.count; ++i) {
        const float x = spec.default_value.numbers[i];
        if (!std::isfinite(x)) return {};
        text += spec.type == pbrt::ValueType::integer ? fmt::format("{:.0f} ", x)
                                                      : fmt::format("{} ", x);
    }
    return text;
}

}  // namespace etalon::test
