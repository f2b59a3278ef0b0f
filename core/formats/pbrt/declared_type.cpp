#include "core/formats/pbrt/declared_type.h"

#include <algorithm>
#include <array>

namespace etalon::pbrt {
namespace {

constexpr std::array types = {
    DeclaredType{"integer", ValueType::integer},
    DeclaredType{"float", ValueType::number},
    DeclaredType{"bool", ValueType::flag, ValueEncoding::flags},
    DeclaredType{"point2", ValueType::point2, ValueEncoding::plain, 2},
    DeclaredType{"vector2", ValueType::vector2, ValueEncoding::plain, 2},
    DeclaredType{"point", ValueType::point, ValueEncoding::plain, 3},
    DeclaredType{"point3", ValueType::point, ValueEncoding::plain, 3},
    DeclaredType{"vector", ValueType::vector, ValueEncoding::plain, 3},
    DeclaredType{"vector3", ValueType::vector, ValueEncoding::plain, 3},
    DeclaredType{"normal", ValueType::normal, ValueEncoding::plain, 3},
    DeclaredType{"string", ValueType::string},
    DeclaredType{"texture", ValueType::string, ValueEncoding::texture_name},
    DeclaredType{"rgb", ValueType::color, ValueEncoding::plain, 3},
    DeclaredType{"color", ValueType::color, ValueEncoding::plain, 3},
    DeclaredType{"xyz", ValueType::color, ValueEncoding::xyz, 3},
    DeclaredType{"blackbody", ValueType::color, ValueEncoding::blackbody, 2},
    DeclaredType{"spectrum", ValueType::color, ValueEncoding::spectrum, 2},
};

constexpr std::string_view blanks = " \t";

std::string_view first_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

}  // namespace

const DeclaredType* find_declared_type(std::string_view word) {
    const auto found = std::ranges::find(types, word, &DeclaredType::word);
    return found != types.end() ? &*found : nullptr;
}

Declaration split_declaration(std::string_view text) {
    const std::string_view type = first_word(text);
    return {type, first_word(text)};
}

std::string_view declared_type_words() {
    return "integer, float, bool, point2, vector2, point, vector, normal, string, texture, rgb, "
           "color, xyz, blackbody, spectrum";
}

}  // namespace etalon::pbrt
