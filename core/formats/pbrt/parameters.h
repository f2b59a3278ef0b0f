#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/copyable_variant.h"
#include "core/formats/pbrt/file_loc.h"
#include "core/formats/pbrt/plugin_type.h"
#include "core/numerics/vec.h"

namespace etalon::pbrt {

/// Number of a texture in the frame.
struct TextureNumber {
    std::uint32_t number;
    bool operator==(const TextureNumber&) const = default;
};

/// Values of a parameter: numbers of every type but integer (points as x y z, colours as r g b),
/// integers and flags (0 or 1), strings, or a texture instead.
using Values = CopyableVariant<std::vector<float>, std::vector<std::int32_t>,
                               std::vector<std::string>, TextureNumber>;

struct Argument {
    const ParameterSpec* spec;
    Values values;
    bool operator==(const Argument&) const = default;
};

/// Parameters of one plugin, checked against its table. Each access names a parameter of that table
/// and a type that it has there. Where the file gives no value, the table's default is returned;
/// zero, an empty text or an empty list if the table has none.
class Parameters {
  public:
    explicit Parameters(const PluginType& type, std::vector<Argument> arguments = {})
        : type_(&type), arguments_(std::move(arguments)) {}

    /// Returns whether the file gives the parameter, as a value or as a texture.
    bool is_given(std::string_view name) const { return find(name) != nullptr; }

    float number(std::string_view name) const;
    std::int32_t integer(std::string_view name) const;
    bool flag(std::string_view name) const { return integer(name) != 0; }
    std::string_view string(std::string_view name) const;  ///< a string, or the path of a file

    /// Returns linear RGB, converted from rgb, xyz, blackbody or spectrum.
    Color color(std::string_view name) const;

    /// Returns a point, vector or normal.
    Vec3f vector(std::string_view name) const;

    /// Returns all numbers of a parameter: 3n for n points, 2n for texture coordinates.
    std::span<const float> numbers(std::string_view name) const;
    std::span<const std::int32_t> integers(std::string_view name) const;

    /// Returns the texture that is bound to the parameter instead of a value.
    std::optional<std::uint32_t> texture(std::string_view name) const;

    /// Returns the parameters that the file gives, in the order of the table.
    std::span<const Argument> arguments() const { return arguments_; }

    bool operator==(const Parameters&) const = default;

  private:
    const Argument* find(std::string_view name) const;
    const ParameterSpec& spec(std::string_view name) const;

    const PluginType* type_;
    std::vector<Argument> arguments_;
};

/// One plugin statement.
struct Plugin {
    const PluginType* type;
    Parameters parameters;
    FileLoc where;

    Plugin(const PluginType& t, std::vector<Argument> arguments = {}, FileLoc loc = {})
        : type(&t), parameters(t, std::move(arguments)), where(loc) {}
};

}  // namespace etalon::pbrt
