// Samplers of pbrt-v3 and their parameters.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr ParameterSpec pixel_samples = integer("pixelsamples", 16);
constexpr ParameterSpec dimensions = integer("dimensions", 4);

constexpr std::array halton = {pixel_samples, flag("samplepixelcenter", false)};
constexpr std::array sobol = {pixel_samples};
constexpr std::array zero_two = {pixel_samples, dimensions};
constexpr std::array random = {integer("pixelsamples", 4)};
constexpr std::array stratified = {flag("jitter", true), integer("xsamples", 4),
                                   integer("ysamples", 4), dimensions};

constexpr std::array types = {
    PluginType{Category::sampler, "halton", halton},
    PluginType{Category::sampler, "sobol", sobol},
    PluginType{Category::sampler, "02sequence", zero_two, "lowdiscrepancy"},
    PluginType{Category::sampler, "maxmindist", zero_two},
    PluginType{Category::sampler, "random", random},
    PluginType{Category::sampler, "stratified", stratified},
};

}  // namespace

std::span<const PluginType> sampler_types() {
    return types;
}

}  // namespace etalon::pbrt
