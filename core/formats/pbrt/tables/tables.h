// Vocabulary of the tables of plugins.
#pragma once

#include <limits>

#include "core/formats/pbrt/plugin_type.h"

namespace etalon::pbrt {

std::span<const PluginType> camera_types();
std::span<const PluginType> sampler_types();
std::span<const PluginType> film_types();
std::span<const PluginType> filter_types();
std::span<const PluginType> integrator_types();
std::span<const PluginType> accelerator_types();
std::span<const PluginType> shape_types();
std::span<const PluginType> material_types();
std::span<const PluginType> float_texture_types();
std::span<const PluginType> spectrum_texture_types();
std::span<const PluginType> light_types();
std::span<const PluginType> area_light_types();
std::span<const PluginType> medium_types();

namespace table {

inline constexpr float infinite = std::numeric_limits<float>::infinity();

constexpr Default value(float x) {
    return {{x}, 1, {}, {}, 1};
}
constexpr Default values(float x, float y, float z) {
    return {{x, y, z}, 3, {}, {}, 1};
}
constexpr Default values(float x, float y, float z, float w) {
    return {{x, y, z, w}, 4, {}, {}, 1};
}
constexpr Default same_as(std::string_view parameter, float factor = 1) {
    return {{}, 0, {}, parameter, factor};
}

// One value.
constexpr ParameterSpec number(std::string_view name, Default d = {}) {
    return {name, ValueType::number, Slot::one, d};
}
constexpr ParameterSpec number(std::string_view name, float x) {
    return number(name, value(x));
}
constexpr ParameterSpec integer(std::string_view name, Default d = {}) {
    return {name, ValueType::integer, Slot::one, d};
}
constexpr ParameterSpec integer(std::string_view name, float x) {
    return integer(name, value(x));
}
constexpr ParameterSpec flag(std::string_view name, bool on) {
    return {name, ValueType::flag, Slot::one, value(on ? 1.0F : 0.0F)};
}
/// A flag whose default depends on other parameters.
constexpr ParameterSpec optional_flag(std::string_view name) {
    return {name, ValueType::flag, Slot::one};
}
constexpr ParameterSpec string(std::string_view name, std::string_view text = {}) {
    return {name, ValueType::string, Slot::one, {{}, 0, text, {}, 1}};
}
/// One of several strings. Any other string is replaced by the default, or by the last argument.
constexpr ParameterSpec choice(std::string_view name, std::string_view text,
                               std::string_view choices, std::string_view if_unknown = {}) {
    ParameterSpec spec = string(name, text);
    spec.choices = choices;
    spec.if_unknown = if_unknown;
    return spec;
}
constexpr ParameterSpec file(std::string_view name, std::string_view text = {}) {
    return {name, ValueType::file, Slot::one, {{}, 0, text, {}, 1}};
}
constexpr ParameterSpec color(std::string_view name, float x) {
    return {name, ValueType::color, Slot::one, values(x, x, x)};
}
constexpr ParameterSpec point(std::string_view name, Default d) {
    return {name, ValueType::point, Slot::one, d};
}
constexpr ParameterSpec vector(std::string_view name, Default d) {
    return {name, ValueType::vector, Slot::one, d};
}

// Any number of values.
constexpr ParameterSpec list(std::string_view name, ValueType type) {
    return {name, type, Slot::list};
}
/// Four numbers or none.
constexpr ParameterSpec four(std::string_view name, ValueType type, Default d = {}) {
    ParameterSpec spec = list(name, type);
    spec.default_value = d;
    spec.length = 4;
    return spec;
}

// A texture or a value. Without a default there is nothing if it is not given.
constexpr ParameterSpec texture_slot(std::string_view name, ValueType type, Default d = {}) {
    return {name, type, Slot::texture, d};
}
constexpr ParameterSpec number_texture(std::string_view name) {
    return texture_slot(name, ValueType::number);
}
constexpr ParameterSpec number_texture(std::string_view name, float x) {
    return texture_slot(name, ValueType::number, value(x));
}
constexpr ParameterSpec color_texture(std::string_view name) {
    return texture_slot(name, ValueType::color);
}
constexpr ParameterSpec color_texture(std::string_view name, float x) {
    return texture_slot(name, ValueType::color, values(x, x, x));
}
constexpr ParameterSpec color_texture(std::string_view name, Default d) {
    return texture_slot(name, ValueType::color, d);
}

constexpr ParameterSpec required(ParameterSpec spec) {
    spec.is_required = true;
    return spec;
}

/// Adds another name or type of the same parameter, for files that do not use the first.
constexpr ParameterSpec also(ParameterSpec spec, std::string_view name, ValueType type) {
    spec.others[spec.other_count++] = {name, type};
    return spec;
}
constexpr ParameterSpec also(const ParameterSpec& spec, std::string_view name) {
    return also(spec, name, spec.type);
}

}  // namespace table
}  // namespace etalon::pbrt
