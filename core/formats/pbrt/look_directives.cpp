// Statements of materials, textures and lights.
#include "core/formats/diagnostic_log.h"
#include "core/formats/nearest_name.h"
#include "core/formats/pbrt/parser.h"
#include "core/formats/pbrt/unused_parameters.h"

namespace etalon::pbrt {
namespace {

using Grade = Unknown::Grade;

/// Returns the plugin that a material names; matte for an unknown one.
const PluginType& material_type(Parser& p, const std::string& name) {
    const PluginType* type = p.find_type(Category::material, name.empty() ? "none" : name,
                                         {Grade::warning, "'matte' stands in for it"});
    return type ? *type : plugin_types(Category::material).front();
}

std::shared_ptr<const StatedMaterial> state(Parser& p, const std::string& name,
                                            ParameterList list) {
    const PluginType& type = material_type(p, name);
    ParameterList* const lists[] = {&list};
    const std::uint32_t number = p.add_material(type, lists, p.in.where());
    if (!type.parameters.empty()) report_unused(list, type, p.log);
    return std::make_shared<StatedMaterial>(
        StatedMaterial{&type, std::move(list), number, p.in.where()});
}

void read_material(Parser& p) {
    const std::string name = p.in.string("a type");
    ParameterList list = p.in.parameters();
    if (p.in.ok()) p.now.graphics.material = state(p, name, std::move(list));
}

void warn_if_animated(Parser& p) {
    if (p.now.transform.current->is_animated()) (void)p.start_transform();
}

void make_named_material(Parser& p) {
    const std::string name = p.in.string("a name");
    ParameterList list = p.in.parameters();
    if (!p.in.ok()) return;
    warn_if_animated(p);
    const std::string type = p.take_type(list);
    if (p.now.materials.define(name, state(p, type, std::move(list)))) {
        p.log.warn(p.in.where(), "redefined", "the material {} is defined again", in_quotes(name));
    }
}

void use_named_material(Parser& p) {
    const std::string name = p.in.string("a name");
    if (!p.in.ok()) return;
    if (const auto* found = p.now.materials.find(name)) {
        p.now.graphics.material = *found;
        return;
    }
    p.log.error(p.in.where(), "undefined", "no material {} is defined; the current one stays{}",
                in_quotes(name), p.log.hint(Severity::error, "undefined", [&] {
                    return did_you_mean(name, p.now.materials.names());
                }));
}

/// Returns the category of a texture's values. Nothing, and an error, if there is none.
std::optional<Category> texture_category(Parser& p, const std::string& type) {
    if (type == "float") return Category::float_texture;
    if (type == "spectrum" || type == "color") return Category::spectrum_texture;
    p.log.error(p.in.where(), "type", "a texture is of type float, spectrum or color, not {}",
                in_quotes(type));
    return std::nullopt;
}

void define_texture(Parser& p, const std::string& name, const PluginType& type,
                    ParameterList& list) {
    std::optional<Plugin> plugin = p.make_plugin(type, list);
    if (!plugin) return;
    auto& names =
        type.category == Category::float_texture ? p.now.textures.numbers : p.now.textures.spectra;
    const auto number = static_cast<std::uint32_t>(p.frame().textures.size());
    p.frame().textures.push_back({std::move(*plugin), p.start_transform()});
    if (names.define(name, number)) {
        p.log.warn(p.in.where(), "redefined", "the {} {} is defined again",
                   to_string(type.category), in_quotes(name));
    }
}

void read_texture(Parser& p) {
    const std::string name = p.in.string("a name"), values = p.in.string("a type of values");
    const std::string class_name = p.in.string("a class");
    ParameterList list = p.in.parameters();
    if (!p.in.ok()) return;
    const std::optional<Category> category = texture_category(p, values);
    if (!category) return;
    const PluginType* const type =
        p.find_type(*category, class_name, {Grade::warning, "it is not defined"});
    if (type) define_texture(p, name, *type, list);
}

void read_light(Parser& p) {
    const std::string name = p.in.string("a type");
    ParameterList list = p.in.parameters();
    if (!p.in.ok()) return;
    const std::uint32_t to_world = p.start_transform();
    const MediumInterface media = p.current_media(p.in.where());
    const PluginType* const type =
        p.find_type(Category::light, name, {Grade::error, "it is left out"});
    if (!type) return;
    if (std::optional<Plugin> plugin = p.make_plugin(*type, list)) {
        p.frame().lights.push_back({std::move(*plugin), to_world, media.outside});
    }
}

void read_area_light(Parser& p) {
    const std::string name = p.in.string("a type");
    ParameterList list = p.in.parameters();
    if (!p.in.ok()) return;
    p.now.graphics.area_light = none;
    if (name.empty()) return;
    const PluginType* const type =
        p.find_type(Category::area_light, name, {Grade::warning, "shapes do not shine"});
    std::optional<Plugin> plugin = type ? p.make_plugin(*type, list) : std::nullopt;
    if (!plugin) return;
    p.now.graphics.area_light = static_cast<std::uint32_t>(p.frame().area_lights.size());
    p.frame().area_lights.push_back(std::move(*plugin));
}

constexpr auto in_world = Directive::Allowed::in_world;

constexpr std::array directives = {
    Directive{"NamedMaterial", in_world, use_named_material},
    Directive{"Material", in_world, read_material},
    Directive{"Texture", in_world, read_texture},
    Directive{"MakeNamedMaterial", in_world, make_named_material},
    Directive{"AreaLightSource", in_world, read_area_light},
    Directive{"LightSource", in_world, read_light},
};

}  // namespace

std::span<const Directive> look_directives() {
    return directives;
}

}  // namespace etalon::pbrt
