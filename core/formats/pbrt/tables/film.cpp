// Films and pixel filters of pbrt-v3 and their parameters.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr std::array image = {integer("xresolution", 1280),
                              integer("yresolution", 720),
                              four("cropwindow", ValueType::number, values(0, 1, 0, 1)),
                              number("scale", 1),
                              number("diagonal", 35),
                              number("maxsampleluminance", infinite),
                              string("filename", "pbrt.exr")};

constexpr std::array films = {PluginType{Category::film, "image", image}};

constexpr std::array box = {number("xwidth", 0.5F), number("ywidth", 0.5F)};
constexpr std::array gaussian = {number("xwidth", 2), number("ywidth", 2), number("alpha", 2)};
constexpr std::array mitchell = {number("xwidth", 2), number("ywidth", 2), number("B", 1.0F / 3),
                                 number("C", 1.0F / 3)};
constexpr std::array sinc = {number("xwidth", 4), number("ywidth", 4), number("tau", 3)};
constexpr std::array triangle = {number("xwidth", 2), number("ywidth", 2)};

constexpr std::array filters = {
    PluginType{Category::filter, "box", box},
    PluginType{Category::filter, "gaussian", gaussian},
    PluginType{Category::filter, "mitchell", mitchell},
    PluginType{Category::filter, "sinc", sinc},
    PluginType{Category::filter, "triangle", triangle},
};

}  // namespace

std::span<const PluginType> film_types() {
    return films;
}

std::span<const PluginType> filter_types() {
    return filters;
}

}  // namespace etalon::pbrt
