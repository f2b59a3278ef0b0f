// Statements of media. MediumInterface stores names: media may be defined after it.
#include "core/formats/pbrt/parser.h"

namespace etalon::pbrt {
namespace {

void make_named_medium(Parser& p) {
    const std::string name = p.in.string("a name");
    ParameterList list = p.in.parameters();
    if (!p.in.ok()) return;
    const std::string type_name = p.take_type(list);
    if (type_name.empty()) return;
    const PluginType* const type =
        p.find_type(Category::medium, type_name, {Unknown::Grade::warning, "it is not defined"});
    if (!type) return;
    std::optional<Plugin> plugin = p.make_plugin(*type, list);
    if (!plugin) return;
    p.now.media[name] = static_cast<std::uint32_t>(p.frame().media.size());
    p.frame().media.push_back({name, std::move(*plugin), p.start_transform()});
}

void set_medium_interface(Parser& p) {
    const std::string inside = p.in.string("a name");
    const std::string outside = p.in.optional_string().value_or(inside);
    if (!p.in.ok()) return;
    p.now.graphics.media =
        std::make_shared<std::array<std::string, 2>>(std::array<std::string, 2>{inside, outside});
    p.frame().has_media = true;
}

constexpr std::array directives = {
    Directive{"MediumInterface", Directive::Allowed::anywhere, set_medium_interface},
    Directive{"MakeNamedMedium", Directive::Allowed::anywhere, make_named_medium},
};

}  // namespace

std::span<const Directive> medium_directives() {
    return directives;
}

}  // namespace etalon::pbrt
