// Shapes of pbrt-v3 and their parameters.
#include <fmt/format.h>

#include "core/formats/diagnostic_log.h"
#include "core/formats/pbrt/parameters.h"
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr ParameterSpec radius = number("radius", 1), phi_max = number("phimax", 360);

constexpr std::array sphere = {radius, number("zmin", same_as("radius", -1)),
                               number("zmax", same_as("radius")), phi_max};
constexpr std::array cylinder = {radius, number("zmin", -1), number("zmax", 1), phi_max};
constexpr std::array disk = {number("height", 0), radius, number("innerradius", 0), phi_max};
constexpr std::array cone = {radius, number("height", 1), phi_max};
constexpr std::array paraboloid = {radius, number("zmin", 0), number("zmax", 1), phi_max};
constexpr std::array hyperboloid = {point("p1", values(0, 0, 0)), point("p2", values(1, 1, 1)),
                                    phi_max};

constexpr std::array curve = {
    number("width", 1),
    number("width0", same_as("width")),
    number("width1", same_as("width")),
    choice("type", "flat", "flat|ribbon|cylinder", "cylinder"),
    string("basis", "bezier"),
    integer("degree", 3),
    also(integer("splitdepth", 3), "splitdepth", ValueType::number),
    required(list("P", ValueType::point)),
    list("N", ValueType::normal),
};

std::optional<Incompatibility> incompatible(std::string text) {
    return Incompatibility{std::move(text), true};
}

/// Refuses normals that a curve of so many segments cannot have, and warns of those it ignores.
std::optional<Incompatibility> check_curve_normals(const Parameters& p, std::size_t segments) {
    const std::size_t normals = p.numbers("N").size() / 3;
    if (p.string("type") != "ribbon") {
        if (normals == 0) return std::nullopt;
        return Incompatibility{"only a curve of type 'ribbon' has normals: they are ignored",
                               false};
    }
    if (normals == segments + 1) return std::nullopt;
    return incompatible(fmt::format("a ribbon of {} segments has {} normals, not {}", segments,
                                    segments + 1, normals));
}

std::optional<Incompatibility> check_curve(const Parameters& p) {
    const std::int32_t stated = p.integer("degree");
    if (stated != 2 && stated != 3) {
        return incompatible(fmt::format("its degree is 2 or 3, not {}", stated));
    }
    const std::string_view basis = p.string("basis");
    if (basis != "bezier" && basis != "bspline") {
        return incompatible(
            fmt::format("its basis is bezier or bspline, not {}", in_quotes(basis)));
    }
    const auto degree = static_cast<std::size_t>(stated);
    const std::size_t points = p.numbers("P").size() / 3;
    if (basis == "bspline") {
        if (points > degree) return check_curve_normals(p, points - degree);
        return incompatible(fmt::format("a b-spline of degree {} has {} points or more, not {}",
                                        degree, degree + 1, points));
    }
    if (points > degree && (points - 1) % degree == 0) {
        return check_curve_normals(p, (points - 1) / degree);
    }
    return incompatible(
        fmt::format("a Bezier curve of degree {} has {} points and {} more for each "
                    "further segment, not {}",
                    degree, degree + 1, degree, points));
}

constexpr ParameterSpec points = required(list("P", ValueType::point));
constexpr ParameterSpec indices = required(list("indices", ValueType::integer));
/// A mask. pbrt-v3 takes the first of several numbers for materials, but not for these.
constexpr ParameterSpec mask(std::string_view name) {
    ParameterSpec spec = number_texture(name, 1);
    spec.length = 1;
    return spec;
}
constexpr ParameterSpec alpha = mask("alpha"), shadow_alpha = mask("shadowalpha");

constexpr ParameterSpec uv =
    also(also(also(list("uv", ValueType::point2), "st"), "uv", ValueType::number), "st",
         ValueType::number);

constexpr std::array triangle_mesh = {indices,
                                      points,
                                      uv,
                                      list("N", ValueType::normal),
                                      list("S", ValueType::vector),
                                      list("faceIndices", ValueType::integer),
                                      alpha,
                                      shadow_alpha};
constexpr std::array ply_mesh = {required(file("filename")), alpha, shadow_alpha};
constexpr std::array heightfield = {required(integer("nu")), required(integer("nv")),
                                    required(list("Pz", ValueType::number))};
constexpr std::array loop_subdiv = {also(integer("levels", 3), "nlevels"), indices, points,
                                    string("scheme", "loop")};
/// Warns of weighted points that are ignored.
std::optional<Incompatibility> check_nurbs(const Parameters& p) {
    if (!p.is_given("P") || !p.is_given("Pw")) return std::nullopt;
    return Incompatibility{"'Pw' is not used: the points 'P' are given, too", false};
}

constexpr std::array nurbs = {
    required(integer("nu")),
    required(integer("nv")),
    required(integer("uorder")),
    required(integer("vorder")),
    required(list("uknots", ValueType::number)),
    required(list("vknots", ValueType::number)),
    number("u0"),
    number("u1"),
    number("v0"),
    number("v1"),
    list("P", ValueType::point),
    list("Pw", ValueType::number),
};

constexpr std::array types = {
    PluginType{Category::shape, "sphere", sphere},
    PluginType{Category::shape, "cylinder", cylinder},
    PluginType{Category::shape, "disk", disk},
    PluginType{Category::shape, "cone", cone},
    PluginType{Category::shape, "paraboloid", paraboloid},
    PluginType{Category::shape, "hyperboloid", hyperboloid},
    PluginType{Category::shape, "curve", curve, {}, {}, check_curve},
    PluginType{Category::shape, "trianglemesh", triangle_mesh},
    PluginType{Category::shape, "plymesh", ply_mesh},
    PluginType{Category::shape, "heightfield", heightfield},
    PluginType{Category::shape, "loopsubdiv", loop_subdiv},
    PluginType{Category::shape, "nurbs", nurbs, {}, {}, check_nurbs},
};

}  // namespace

std::span<const PluginType> shape_types() {
    return types;
}

}  // namespace etalon::pbrt
