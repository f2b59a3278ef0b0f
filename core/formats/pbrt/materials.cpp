// Materials of a frame, and those that shapes state anew.
#include "core/formats/diagnostic_log.h"
#include "core/formats/nearest_name.h"
#include "core/formats/pbrt/parser.h"

namespace etalon::pbrt {
namespace {

/// Takes the argument of a parameter out of the list; empty if it is not there.
std::string take_string(const ParameterSpec& spec, std::vector<Argument>& arguments) {
    const auto found = std::ranges::find(arguments, &spec, &Argument::spec);
    if (found == arguments.end()) return {};
    std::string text = std::get<std::vector<std::string>>(found->values).front();
    arguments.erase(found);
    return text;
}

/// Returns the number of a named material. An unknown one is replaced by matte, with the parameters
/// of the material that names it.
std::uint32_t named_material(Parser& p, const std::string& name,
                             std::span<ParameterList* const> lists, FileLoc where) {
    if (const auto* found = p.now.materials.find(name)) return (*found)->number;
    p.log.error(where, "undefined", "no material {} is defined; 'matte' stands in for it{}",
                in_quotes(name), p.log.hint(Severity::error, "undefined", [&] {
                    return did_you_mean(name, p.now.materials.names());
                }));
    return p.add_material(plugin_types(Category::material).front(), lists, where);
}

}  // namespace

std::uint32_t Parser::add_material(const PluginType& type, std::span<ParameterList* const> lists,
                                   FileLoc where) {
    // No parameter of a material is required.
    std::vector<Argument> arguments =
        binder().bind(type, lists, where).value_or(std::vector<Argument>());
    std::array<std::uint32_t, 2> mixed = {none, none};
    std::size_t count = 0;
    for (const ParameterSpec& spec : type.parameters) {
        if (spec.type != ValueType::material) continue;
        mixed[count++] = named_material(*this, take_string(spec, arguments), lists, where);
    }
    return now.material_pool.add({Plugin(type, std::move(arguments), where), mixed},
                                 frame().materials);
}

}  // namespace etalon::pbrt
