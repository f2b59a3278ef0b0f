// The statement of a shape, to which all previous state applies.
#include <algorithm>

#include "core/formats/pbrt/parser.h"
#include "core/formats/pbrt/unused_parameters.h"

namespace etalon::pbrt {
namespace {

struct NotOfMaterials {
    ValueType type;
    std::string_view name;
};

constexpr std::array not_of_materials = {
    NotOfMaterials{ValueType::number, "radius"},
    NotOfMaterials{ValueType::string, "filename"},
    NotOfMaterials{ValueType::string, "type"},
    NotOfMaterials{ValueType::string, "scheme"},
};

/// Returns whether pbrt-v3 assumes that a shape's parameter might be meant for its material: any
/// texture but a mask, any single value but a few.
bool may_be_of_material(const GivenParameter& given) {
    if (given.is_texture) return given.name != "alpha" && given.name != "shadowalpha";
    return given.count() == 1 && std::ranges::none_of(not_of_materials, [&](const auto& n) {
               return n.type == given.type && n.name == given.name;
           });
}

/// Returns the current material; the first in a frame is matte.
const StatedMaterial& current_material(Parser& p) {
    if (!p.now.graphics.material) {
        const PluginType& matte = plugin_types(Category::material).front();
        p.now.graphics.material = std::make_shared<StatedMaterial>(
            StatedMaterial{&matte, {}, p.add_material(matte, {}, {}), {}});
    }
    return *p.now.graphics.material;
}

/// Returns the current material with the shape's parameters instead of its own. Names of its
/// textures are resolved now.
std::uint32_t restated_material(Parser& p, ParameterList& shape) {
    const StatedMaterial& stated = current_material(p);
    ParameterList own = stated.parameters;
    ParameterList* const lists[] = {&shape, &own};
    return p.add_material(*stated.type, lists, p.in.where());
}

/// Returns the area light of the shape; none, with a warning, if pbrt-v3 drops it.
std::uint32_t area_light_of_shape(Parser& p) {
    const std::uint32_t light = p.now.graphics.area_light;
    if (light == none) return none;
    if (p.now.transform.current->is_animated()) {
        p.log.warn(p.in.where(), "area-light", "a shape that moves cannot be a light");
        return none;
    }
    if (p.now.object != none) {
        p.log.warn(p.in.where(), "area-light", "a shape of an object cannot be a light");
        return none;
    }
    return light;
}

void read_shape(Parser& p) {
    const std::string name = p.in.string("a type");
    ParameterList list = p.in.parameters();
    if (!p.in.ok()) return;
    const PluginType* const type =
        p.find_type(Category::shape, name, {Unknown::Grade::warning, "it is left out"});
    if (!type) return;
    // Counted now, as the shape moves long lists.
    const bool restates_material = std::ranges::any_of(list.parameters, may_be_of_material);
    ParameterList* const lists[] = {&list};
    std::optional<std::vector<Argument>> arguments = p.binder().bind(*type, lists, p.in.where());
    if (!arguments) return;
    Plugin plugin(*type, std::move(*arguments), p.in.where());
    if (!p.check(plugin)) return;
    const std::uint32_t material =
        restates_material ? restated_material(p, list) : current_material(p).number;
    report_unused(list, *type, p.log);
    Shape shape{std::move(plugin),
                p.transform_pair(),
                material,
                area_light_of_shape(p),
                p.current_media(p.in.where()),
                p.now.graphics.reverse_orientation};
    auto& shapes = p.now.object == none ? p.frame().shapes : p.frame().objects[p.now.object].shapes;
    shapes.push_back(std::move(shape));
}

constexpr std::array directives = {Directive{"Shape", Directive::Allowed::in_world, read_shape}};

}  // namespace

std::span<const Directive> shape_directives() {
    return directives;
}

}  // namespace etalon::pbrt
