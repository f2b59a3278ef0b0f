// Statements of media. MediumInterface stores names: media may be defined after it.
#include "core/formats/pbrt/parser.h"

namespace etalon::pbrt {
namespace {

/// Whether a medium has as many densities as its grid has cells; says so if not.
bool is_whole_grid(Parser& p, const Plugin& medium) {
    if (!medium.type->find("density")) return true;
    const Parameters& m = medium.parameters;
    const std::int64_t nx = m.integer("nx"), ny = m.integer("ny"), nz = m.integer("nz");
    const std::size_t given = m.numbers("density").size();
    const bool is_sane = nx > 0 && ny > 0 && nz > 0 && nx * ny <= std::int64_t{1} << 31;
    if (is_sane && static_cast<std::uint64_t>(nx * ny * nz) == given) return true;
    p.log.error(p.in.where(), "count",
                "the medium is left out: it has {} densities for {} x {} x {}", given, nx, ny, nz);
    return false;
}

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
    if (!plugin || !is_whole_grid(p, *plugin)) return;
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
