#include "core/formats/prt/prt.h"

#include "core/formats/prt/prt_loader.h"
#include "core/formats/statements.h"

namespace etalon {
namespace {

using prt::Loader;
using Entry = Keyword<Loader>;

constexpr std::array objects = {
    Entry{"polygon", [](Loader& l) { read_polygon(l); }},
    Entry{"sphere", [](Loader& l) { read_sphere(l); }},
    Entry{"cone", [](Loader& l) { read_cone(l); }},
    Entry{"surface", prt::read_surface},
    Entry{"hsphere", prt::read_hollow_sphere},
    Entry{"ring", prt::read_ring},
    Entry{"quadric", prt::read_quadric},
};

constexpr std::array others = {
    Entry{"instance_of", prt::read_instance_of},
    Entry{"instance", prt::read_instance},
    Entry{"end_instance", prt::read_end_instance},
    Entry{"light", prt::read_light},
    Entry{"background", prt::read_background},
    Entry{"from", prt::read_from},
    Entry{"at", prt::read_at},
    Entry{"up", prt::read_up},
    Entry{"angle", prt::read_angle},
    Entry{"resolution", prt::read_resolution},
};

constexpr auto keywords = [] {
    std::array<Entry, objects.size() + others.size()> all{};
    std::ranges::copy(others, std::ranges::copy(objects, all.begin()).out);
    return all;
}();

constexpr auto names = names_of(keywords);

}  // namespace

namespace prt {

std::span<const std::string_view> object_names() {
    return std::span(names).first(objects.size());
}

void read_objects(Loader& loader) {
    read_statements(loader, objects);
}

}  // namespace prt

LoadResult load_prt(std::string_view text, const std::string& path, const LoadOptions& options) {
    DiagnosticLog log(path, text, options.strict);
    Loader loader{{Reader(text, log, names), options, std::filesystem::path(path).parent_path()},
                  text};
    loader.settings.display_colors = true;
    read_statements(loader, keywords);
    if (loader.open) prt::drop_open_definition(loader);
    finalize_view(loader);
    return loader.finish(log);
}

}  // namespace etalon
