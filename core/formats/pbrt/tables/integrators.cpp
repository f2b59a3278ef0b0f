// Integrators of pbrt-v3 and their parameters.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr ParameterSpec max_depth = integer("maxdepth", 5);
constexpr ParameterSpec pixel_bounds = four("pixelbounds", ValueType::integer);
constexpr std::string_view strategies = "spatial|uniform|power";

constexpr std::array path = {max_depth, pixel_bounds, number("rrthreshold", 1),
                             choice("lightsamplestrategy", "spatial", strategies)};
constexpr std::array direct_lighting = {max_depth, pixel_bounds,
                                        choice("strategy", "all", "all|one")};
constexpr std::array whitted = {max_depth, pixel_bounds};
constexpr std::array bdpt = {max_depth, pixel_bounds,
                             choice("lightsamplestrategy", "power", strategies),
                             flag("visualizestrategies", false), flag("visualizeweights", false)};
constexpr std::array mlt = {max_depth,
                            integer("bootstrapsamples", 100000),
                            integer("chains", 1000),
                            integer("mutationsperpixel", 100),
                            number("largestepprobability", 0.3F),
                            number("sigma", 0.01F)};
// The source writes 2^31 as an int, where it is negative: no image before the last.
constexpr std::array sppm = {also(integer("iterations", 64), "numiterations"), max_depth,
                             integer("photonsperiteration", -1),
                             integer("imagewritefrequency", -2147483648.0F), number("radius", 1)};
constexpr std::array ambient_occlusion = {flag("cossample", true), integer("nsamples", 64),
                                          pixel_bounds};

constexpr std::string_view as_path =
    "path, which converges to the same image but for caustics of lights without extent";
constexpr std::string_view as_volpath =
    "volpath, which converges to the same image but for caustics of lights without extent";

constexpr std::array types = {
    PluginType{Category::integrator, "path", path},
    PluginType{Category::integrator, "volpath", path},
    PluginType{Category::integrator, "directlighting", direct_lighting},
    PluginType{Category::integrator, "whitted", whitted},
    PluginType{Category::integrator, "bdpt", bdpt, {}, as_volpath},
    PluginType{Category::integrator, "mlt", mlt, {}, as_volpath},
    PluginType{Category::integrator, "sppm", sppm, {}, as_path},
    PluginType{Category::integrator, "ambientocclusion", ambient_occlusion},
};

}  // namespace

std::span<const PluginType> integrator_types() {
    return types;
}

}  // namespace etalon::pbrt
