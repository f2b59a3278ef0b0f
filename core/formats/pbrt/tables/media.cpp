// Media of pbrt-v3 and their parameters.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr ParameterSpec absorption = {"sigma_a", ValueType::color, Slot::one,
                                      values(0.0011F, 0.0024F, 0.014F)};
constexpr ParameterSpec scattering = {"sigma_s", ValueType::color, Slot::one,
                                      values(2.55F, 3.21F, 3.77F)};
constexpr ParameterSpec preset = string("preset"), g = number("g", 0), scale = number("scale", 1);

constexpr std::array homogeneous = {absorption, scattering, preset, g, scale};
constexpr std::array heterogeneous = {absorption,
                                      scattering,
                                      preset,
                                      g,
                                      scale,
                                      integer("nx", 1),
                                      integer("ny", 1),
                                      integer("nz", 1),
                                      point("p0", values(0, 0, 0)),
                                      point("p1", values(1, 1, 1)),
                                      required(list("density", ValueType::number))};

constexpr std::array types = {
    PluginType{Category::medium, "homogeneous", homogeneous, {}, "nothing"},
    PluginType{Category::medium, "heterogeneous", heterogeneous, {}, "nothing"},
};

}  // namespace

std::span<const PluginType> medium_types() {
    return types;
}

}  // namespace etalon::pbrt
