// Lights of pbrt-v3 and their parameters. Every "scale" is a colour.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr ParameterSpec intensity = color("I", 1), radiance = color("L", 1);
constexpr ParameterSpec scale = color("scale", 1);
constexpr ParameterSpec from = point("from", values(0, 0, 0)), to = point("to", values(0, 0, 1));
constexpr ParameterSpec map_name = file("mapname");
constexpr ParameterSpec samples = also(integer("samples", 1), "nsamples");

constexpr std::array point_light = {intensity, scale, from};
constexpr std::array spot = {
    intensity, scale, from, to, number("coneangle", 30), number("conedeltaangle", 5)};
constexpr std::array distant = {radiance, scale, from, to};
constexpr std::array infinite_light = {radiance, scale, map_name, samples};
constexpr std::array goniometric = {intensity, scale, map_name};
constexpr std::array projection = {intensity, scale, number("fov", 45), map_name};
constexpr std::array diffuse = {radiance, scale, flag("twosided", false), samples};

constexpr std::array lights = {
    PluginType{Category::light, "point", point_light},
    PluginType{Category::light, "spot", spot},
    PluginType{Category::light, "distant", distant},
    PluginType{Category::light, "infinite", infinite_light, "exinfinite"},
    PluginType{Category::light, "goniometric", goniometric},
    PluginType{Category::light, "projection", projection},
};

constexpr std::array area_lights = {PluginType{Category::area_light, "diffuse", diffuse, "area"}};

}  // namespace

std::span<const PluginType> light_types() {
    return lights;
}

std::span<const PluginType> area_light_types() {
    return area_lights;
}

}  // namespace etalon::pbrt
