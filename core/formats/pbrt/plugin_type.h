// Plugins of pbrt-v3 and their parameters, described by tables: name, type, default.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace etalon::pbrt {

/// Type of a parameter's values.
enum class ValueType : std::uint8_t {
    number,
    integer,
    flag,
    string,
    file,      ///< string that names a file; read as its path
    material,  ///< string that names a material; bound as Material::mixed, not as an argument
    color,
    point2,
    vector2,
    point,
    vector,
    normal,
};

/// Kind of values that a parameter accepts.
enum class Slot : std::uint8_t {
    one,      ///< exactly one value; with any other number of values it is not used
    list,     ///< any number of values
    texture,  ///< a texture, or the first of the values
};

/// Default of a parameter: up to four numbers, a text, another parameter times a factor, or none.
struct Default {
    std::array<float, 4> numbers{};
    std::uint8_t count = 0;    ///< numbers in use; a flag is 0 or 1
    std::string_view text;     ///< for strings
    std::string_view same_as;  ///< parameter whose value is the default of this one
    float factor = 1;          ///< factor of `same_as`
    bool operator==(const Default&) const = default;
};

/// Another name or type under which a parameter may be given.
struct Spelling {
    std::string_view name;
    ValueType type;
};

struct ParameterSpec {
    std::string_view name;
    ValueType type;
    Slot slot;
    Default default_value{};
    std::array<Spelling, 3> others{};  ///< used, in order, if `name` is not given
    std::uint8_t other_count = 0;
    std::string_view choices{};     ///< accepted strings, separated by '|'; empty: any
    std::uint8_t length = 0;        ///< number of values that must be given; 0: as `slot` says
    std::string_view if_unknown{};  ///< replaces a string that is no choice; empty: the default
    bool is_required = false;       ///< if it is missing the statement is left out

    std::span<const Spelling> other_spellings() const { return {others.data(), other_count}; }
};

enum class Category : std::uint8_t {
    camera,
    sampler,
    film,
    filter,
    integrator,
    accelerator,
    shape,
    material,
    float_texture,
    spectrum_texture,
    light,
    area_light,
    medium,
};

inline constexpr std::size_t category_count = 13;

class Parameters;

/// Parameters that pbrt-v3 does not accept together.
struct Incompatibility {
    std::string text;
    bool leaves_out;  ///< whether the plugin is left out, or only a parameter ignored
};

struct PluginType {
    Category category;
    std::string_view name;
    std::span<const ParameterSpec> parameters;
    std::string_view alias{};     ///< another name, or empty
    std::string_view stand_in{};  ///< what Etalon renders instead; empty: the plugin itself

    std::optional<Incompatibility> (*check)(const Parameters&) =
        nullptr;  ///< null: all are compatible

    /// Returns the specification of a parameter by its own name; null if there is none.
    const ParameterSpec* find(std::string_view parameter) const;
};

/// Returns the plugins of a category. The first one is the default if the statement is missing.
std::span<const PluginType> plugin_types(Category category);

/// Returns the plugin of this name or alias; null if there is none.
const PluginType* find_plugin(Category category, std::string_view name);

/// Returns the category in words: "camera", "area light".
std::string_view to_string(Category category);

/// Returns the type as pbrt-v3 writes it: "float", "integer", "point3".
std::string_view to_string(ValueType type);

/// Returns how many numbers make one value of the type: 3 for a point.
int components(ValueType type);

}  // namespace etalon::pbrt
