#include "core/formats/pbrt/plugin_text.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>

namespace etalon::pbrt {
namespace {

constexpr std::size_t values_of_a_line = 6;

std::string escaped(char c) {
    if (c == '\n') return "\\n";
    return c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
}

/// Returns the shortest numbers that read back to these, in brackets; long lists on lines of their
/// own.
template <class T>
std::string list_text(const std::vector<T>& values, std::size_t width) {
    const std::size_t line = values_of_a_line * width;
    std::string text = "[";
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += i % line == 0 && values.size() > line ? '\n' : ' ';
        char digits[32];
        text.append(digits, std::to_chars(digits, std::end(digits), values[i]).ptr);
    }
    return text + " ]";
}

/// Returns the values of a parameter as a file gives them.
struct ValueText {
    const ParameterSpec& spec;
    const std::filesystem::path& directory;

    std::string operator()(const std::vector<float>& values) const {
        return list_text(values, static_cast<std::size_t>(components(spec.type)));
    }
    std::string operator()(const std::vector<std::int32_t>& values) const {
        if (spec.type == ValueType::flag) return values.front() != 0 ? "\"true\"" : "\"false\"";
        return list_text(values, 1);
    }
    std::string operator()(const std::vector<std::string>& values) const {
        const std::string& text = values.front();
        const bool is_path = spec.type == ValueType::file && !text.empty();
        return quote(is_path ? path_text(text) : text);
    }
    std::string operator()(const TextureNumber& texture) const {
        return quote(texture_name(texture.number));
    }

    std::string path_text(const std::filesystem::path& path) const {
        if (path.is_absolute()) return path.string();
        std::error_code unknown;
        const std::filesystem::path from = directory.empty() ? "." : directory;
        const std::filesystem::path near = std::filesystem::proximate(path, from, unknown);
        return unknown ? path.string() : near.string();
    }
};

std::string_view type_word(const Argument& argument) {
    const bool is_texture = std::holds_alternative<TextureNumber>(argument.values);
    return is_texture ? "texture" : to_string(argument.spec->type);
}

}  // namespace

std::string quote(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) result += escaped(c);
    return result + '"';
}

std::string texture_name(std::uint32_t number) {
    return fmt::format("texture-{}", number);
}

std::string material_name(std::uint32_t number) {
    return fmt::format("material-{}", number);
}

std::string parameters_text(const Plugin& plugin, const std::filesystem::path& directory) {
    std::string text;
    for (const Argument& a : plugin.parameters.arguments()) {
        text += fmt::format(" \"{} {}\" {}", type_word(a), a.spec->name,
                            std::visit(ValueText{*a.spec, directory}, a.values));
    }
    return text;
}

std::string matrix_text(const Matrix4& matrix) {
    std::string text = "[";
    for (std::size_t i = 0; i < 16; ++i) text += fmt::format(" {}", matrix[i % 4][i / 4]);
    return text + " ]";
}

}  // namespace etalon::pbrt
