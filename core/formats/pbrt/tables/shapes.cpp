// Shapes of pbrt-v3 and their parameters.
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
    choice("type", "flat", "flat|ribbon|cylinder"),
    choice("basis", "bezier", "bezier|bspline"),
    integer("degree", 3),
    also(integer("splitdepth", 3), "splitdepth", ValueType::number),
    required(list("P", ValueType::point)),
    list("N", ValueType::normal),
};

constexpr ParameterSpec points = required(list("P", ValueType::point));
constexpr ParameterSpec indices = required(list("indices", ValueType::integer));
constexpr ParameterSpec alpha = number_texture("alpha", 1);
constexpr ParameterSpec shadow_alpha = number_texture("shadowalpha", 1);

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
    PluginType{Category::shape, "curve", curve, {}, "nothing"},
    PluginType{Category::shape, "trianglemesh", triangle_mesh},
    PluginType{Category::shape, "plymesh", ply_mesh},
    PluginType{Category::shape, "heightfield", heightfield, {}, "nothing"},
    PluginType{Category::shape, "loopsubdiv", loop_subdiv},
    PluginType{Category::shape, "nurbs", nurbs, {}, "nothing"},
};

}  // namespace

std::span<const PluginType> shape_types() {
    return types;
}

}  // namespace etalon::pbrt
