#include "core/formats/pbrt/parameters.h"

#include <algorithm>
#include <cassert>

namespace etalon::pbrt {
namespace {

template <class T>
const std::vector<T>* values_of(const Argument* argument) {
    return argument ? std::get_if<std::vector<T>>(&argument->values) : nullptr;
}

}  // namespace

const ParameterSpec& Parameters::spec(std::string_view name) const {
    const ParameterSpec* const found = type_->find(name);
    assert(found && "a parameter that is not in the plugin's table");
    return *found;
}

const Argument* Parameters::find(std::string_view name) const {
    const auto found =
        std::ranges::find(arguments_, name, [](const Argument& a) { return a.spec->name; });
    return found != arguments_.end() ? &*found : nullptr;
}

float Parameters::number(std::string_view name) const {
    if (const auto* given = values_of<float>(find(name))) return given->front();
    const Default& d = spec(name).default_value;
    return d.same_as.empty() ? d.numbers[0] : d.factor * number(d.same_as);
}

std::int32_t Parameters::integer(std::string_view name) const {
    if (const auto* given = values_of<std::int32_t>(find(name))) return given->front();
    return static_cast<std::int32_t>(spec(name).default_value.numbers[0]);
}

std::string_view Parameters::string(std::string_view name) const {
    if (const auto* given = values_of<std::string>(find(name))) return given->front();
    return spec(name).default_value.text;
}

Color Parameters::color(std::string_view name) const {
    const std::span<const float> c = numbers(name);
    return c.size() < 3 ? Color(0.0F) : Color(c[0], c[1], c[2]);
}

Vec3f Parameters::vector(std::string_view name) const {
    const std::span<const float> v = numbers(name);
    return v.size() < 3 ? Vec3f(0.0F) : Vec3f(v[0], v[1], v[2]);
}

std::span<const float> Parameters::numbers(std::string_view name) const {
    if (const auto* given = values_of<float>(find(name))) return *given;
    const Default& d = spec(name).default_value;
    return std::span(d.numbers).first(d.count);
}

std::span<const std::int32_t> Parameters::integers(std::string_view name) const {
    const auto* given = values_of<std::int32_t>(find(name));
    return given ? std::span<const std::int32_t>(*given) : std::span<const std::int32_t>();
}

std::optional<std::uint32_t> Parameters::texture(std::string_view name) const {
    const Argument* const argument = find(name);
    const auto* given = argument ? std::get_if<TextureNumber>(&argument->values) : nullptr;
    return given ? std::optional(given->number) : std::nullopt;
}

}  // namespace etalon::pbrt
