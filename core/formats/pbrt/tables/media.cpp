// Media of pbrt-v3 and their parameters.
#include <fmt/format.h>

#include "core/formats/pbrt/parameters.h"
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

/// Refuses a grid that has another number of densities than of cells.
std::optional<Incompatibility> check_grid(const Parameters& m) {
    const std::int64_t nx = m.integer("nx"), ny = m.integer("ny"), nz = m.integer("nz");
    const std::size_t given = m.numbers("density").size();
    const bool is_sane = nx > 0 && ny > 0 && nz > 0 && nx * ny <= std::int64_t{1} << 31;
    if (is_sane && static_cast<std::uint64_t>(nx * ny * nz) == given) return std::nullopt;
    return Incompatibility{fmt::format("it has {} densities for {} x {} x {}", given, nx, ny, nz),
                           true};
}

constexpr std::array types = {
    PluginType{Category::medium, "homogeneous", homogeneous},
    PluginType{Category::medium, "heterogeneous", heterogeneous, {}, {}, check_grid},
};

}  // namespace

std::span<const PluginType> medium_types() {
    return types;
}

}  // namespace etalon::pbrt
