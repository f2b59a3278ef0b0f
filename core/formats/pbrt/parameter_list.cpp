#include "core/formats/pbrt/parameter_list.h"

#include <algorithm>

namespace etalon::pbrt {

std::size_t GivenParameter::count() const {
    const std::size_t numbers = std::visit([](const auto& v) { return v.size(); }, values);
    return numbers / static_cast<std::size_t>(components(type));
}

GivenParameter* ParameterList::find(std::string_view name, ValueType type) {
    const auto found = std::ranges::find_if(parameters, [&](const GivenParameter& p) {
        return p.type == type && !p.is_texture && p.name == name;
    });
    return found != parameters.end() ? &*found : nullptr;
}

GivenParameter* ParameterList::find_texture(std::string_view name) {
    const auto found = std::ranges::find_if(
        parameters, [&](const GivenParameter& p) { return p.is_texture && p.name == name; });
    return found != parameters.end() ? &*found : nullptr;
}

bool ParameterList::add(GivenParameter parameter) {
    GivenParameter* const earlier =
        parameter.is_texture ? find_texture(parameter.name) : find(parameter.name, parameter.type);
    if (!earlier) {
        parameters.push_back(std::move(parameter));
        return false;
    }
    *earlier = std::move(parameter);
    return true;
}

}  // namespace etalon::pbrt
