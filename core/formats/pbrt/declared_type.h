#pragma once

#include <optional>
#include <string_view>

#include "core/formats/pbrt/plugin_type.h"

namespace etalon::pbrt {

/// Conversion of the numbers or strings of a parameter to values.
enum class ValueEncoding : std::uint8_t { plain, flags, texture_name, xyz, blackbody, spectrum };

/// The type that a parameter declares.
struct DeclaredType {
    std::string_view word;
    ValueType type;
    ValueEncoding encoding = ValueEncoding::plain;
    int numbers = 1;  ///< numbers that make one value; 0: all of them

    bool takes_strings() const {
        return type == ValueType::string || encoding == ValueEncoding::flags;
    }
};

/// Returns nothing if there is no such type.
const DeclaredType* find_declared_type(std::string_view word);

struct Declaration {
    std::string_view type, name;  ///< empty if missing
};

/// Splits "type name" at its blanks.
Declaration split_declaration(std::string_view text);

/// Returns the words that pbrt-v3 accepts as types.
std::string_view declared_type_words();

}  // namespace etalon::pbrt
