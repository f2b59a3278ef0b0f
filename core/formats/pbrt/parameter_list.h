#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/copyable_variant.h"
#include "core/formats/pbrt/file_loc.h"
#include "core/formats/pbrt/plugin_type.h"

namespace etalon::pbrt {

/// A parameter as a file gives it, before it is bound to a plugin. Colours of every kind are RGB.
struct GivenParameter {
    std::string name;
    ValueType type;           ///< never `file`
    bool is_texture = false;  ///< the value is a texture's name
    bool is_used = false;
    CopyableVariant<std::vector<float>, std::vector<std::int32_t>, std::vector<std::string>>
        values{};
    FileLoc where{};
    std::string_view type_word{};  ///< the type as written: "float", "texture", "xyz"
    FileLoc not_finite{};          ///< the first infinite number or NaN; line 0 if all are finite

    /// Returns the number of values: points, not coordinates.
    std::size_t count() const;
};

/// Parameters of a statement. Of two with the same name and type the later one is kept.
struct ParameterList {
    std::vector<GivenParameter> parameters;

    GivenParameter* find(std::string_view name, ValueType type);
    GivenParameter* find_texture(std::string_view name);

    /// Adds a parameter, replacing an earlier one. Returns whether there was one.
    bool add(GivenParameter parameter);
};

}  // namespace etalon::pbrt
