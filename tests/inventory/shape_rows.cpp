#include <array>

#include "tests/inventory/row.h"

namespace etalon::test {
namespace {

constexpr std::string_view square =
    "\"integer indices\" [0 1 2 0 2 3] \"point P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0] ";
constexpr std::string_view waves = "\"point P\" [-1 -1 0  -.5 1 0  .5 -1 0  1 1 0] ";
constexpr std::string_view wide_waves =
    "\"point P\" [-1 -1 0  -.5 1 0  .5 -1 0  1 1 0] \"float width\" 0.4 ";
constexpr std::string_view seven =
    "\"float width\" 0.3 "
    "\"point P\" [-1 -1 0  -.8 1 0  -.5 -1 0  0 0 0  .5 1 .2  .7 -1 0  1 1 0] ";
constexpr std::string_view ribbon =
    "\"point P\" [-1 -1 0  -.5 1 0  .5 -1 0  1 1 0] \"float width\" 0.4 \"string type\" "
    "\"ribbon\" ";
constexpr std::string_view heights = "\"float Pz\" [0 .3 0 .5 0 1] ";
constexpr std::string_view heights_of = "\"integer nu\" 3 \"integer nv\" 2 ";
constexpr std::string_view tetrahedron = "\"point P\" [-1 -1 -1  1 -1 -1  0 1 0  0 -1 1] ";
constexpr std::string_view tetrahedron_faces = "\"integer indices\" [0 2 1 0 1 3 1 2 3 2 0 3] ";
constexpr std::string_view tetrahedron_solid =
    "\"integer indices\" [0 2 1 0 1 3 1 2 3 2 0 3] "
    "\"point P\" [-1 -1 -1  1 -1 -1  0 1 0  0 -1 1] ";
constexpr std::string_view patch_knots =
    "\"integer nu\" 3 \"integer nv\" 3 \"integer uorder\" 2 \"integer vorder\" 2 "
    "\"float uknots\" [0 0 .5 1 1] \"float vknots\" [0 0 .5 1 1] ";
constexpr std::string_view patch =
    "\"integer nu\" 3 \"integer nv\" 3 \"integer uorder\" 2 \"integer vorder\" 2 "
    "\"float uknots\" [0 0 .5 1 1] \"float vknots\" [0 0 .5 1 1] "
    "\"point P\" [-1 -1 0  0 -1 .5  1 -1 0  -1 0 .5  0 0 -.5  1 0 .7  -1 1 0  0 1 .5  1 1 0] ";

// Of a parameter that is given twice, the last one is used. If numbers of values must agree, a
// value also contains the parameters that belong to it.
constexpr std::array shapes = {
    Row{"hyperboloid", "p1", "0.6 0 -0.5"},
    Row{"hyperboloid", "p2", "0.4 0.8 0.5"},
    Row{"*", "radius", "0.6"},
    Row{"*", "zmin", "0.2"},
    Row{"*", "zmax", "0.4"},
    Row{"*", "phimax", "200"},
    Row{"*", "height", "0.4"},
    Row{"disk", "innerradius", "0.5"},
    Row{"curve", "width", "0.2", waves},
    Row{"curve", "width0", "0.1", wide_waves},
    Row{"curve", "width1", "0.1", wide_waves},
    Row{"curve", "type", "cylinder", wide_waves},
    Row{"curve", "basis", "bspline", wide_waves},
    Row{"curve", "degree", "2", seven},
    Row{"curve", "P", "-1 -1 0  -.5 1 0  .5 1 0  1 -1 0", "\"float width\" 0.4",
        "-1 -1 0 -.5 1 0 .5 -1 0 1 1 0"},
    Row{"curve", "N", "0 0 1  0 1 0", ribbon, "0 0 1  0 0 1"},
    Row{"curve", "splitdepth", "0", wide_waves},
    Row{"trianglemesh", "indices", "0 1 2 0 1 3", "\"point P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0]",
        "0 1 2 0 2 3"},
    Row{"trianglemesh", "P", "-1 -1 0 1 -1 0 1 0.4 0 -1 1 0", "\"integer indices\" [0 1 2 0 2 3]",
        "-1 -1 0 1 -1 0 1 1 0 -1 1 0"},
    Row{"trianglemesh", "uv", "0 0 .4 0 .4 .4 0 .4", square},
    Row{"trianglemesh", "N", "0 1 -1 0 1 -1 0 -1 -1 0 -1 -1", square},
    Row{"trianglemesh",
        "S",
        "1 1 0 1 1 0 1 1 0 1 1 0",
        square,
        {},
        "the frames of anisotropic materials follow the coordinates"},
    Row{"trianglemesh", "faceIndices", "1 2", square, {}, "only ptex needs them"},
    Row{"trianglemesh", "alpha", "0", square},
    Row{"trianglemesh", "shadowalpha", "0", square},
    Row{"plymesh", "filename", "b.ply", {}, "a.ply"},
    Row{"plymesh", "alpha", "0", "\"string filename\" \"a.ply\""},
    Row{"plymesh", "shadowalpha", "0", "\"string filename\" \"a.ply\""},
    Row{"heightfield", "nu", "3 ] \"integer nv\" [ 2", heights, "2 ] \"integer nv\" [ 3"},
    Row{"heightfield", "nv", "3 ] \"integer nu\" [ 2", heights, "2 ] \"integer nu\" [ 3"},
    Row{"heightfield", "Pz", "0 1 0 1 0 0", heights_of, "0 .3 0 .5 0 1"},
    Row{"loopsubdiv", "levels", "1", tetrahedron_solid},
    Row{"loopsubdiv", "indices", "0 2 1 0 1 3 1 2 3", tetrahedron, "0 2 1 0 1 3 1 2 3 2 0 3"},
    Row{"loopsubdiv", "P", "-1 -1 -1  1 -1 -1  0 0.4 0  0 -1 1", tetrahedron_faces,
        "-1 -1 -1  1 -1 -1  0 1 0  0 -1 1"},
    Row{"loopsubdiv", "scheme", "x", tetrahedron_solid, {}, "pbrt-v3 has one scheme, too"},
    Row{"nurbs", "nu",
        "2 ] \"float uknots\" [0 0 1 1] \"point P\" [-1 -1 0 1 -1 0 -1 1 0 1 1 1 -1 2 0 1 2 0",
        patch},
    Row{"nurbs", "nv",
        "2 ] \"float vknots\" [0 0 1 1] \"point P\" [-1 -1 0 0 -1 .5 1 -1 0 -1 1 0 0 1 .5 1 1 0",
        patch},
    Row{"nurbs", "uorder", "3 ] \"float uknots\" [0 0 0 1 1 1", patch},
    Row{"nurbs", "vorder", "3 ] \"float vknots\" [0 0 0 1 1 1", patch},
    Row{"nurbs", "uknots", "0 0 .2 1 1", patch},
    Row{"nurbs", "vknots", "0 0 .2 1 1", patch},
    Row{"nurbs", "u0", "0.3", patch},
    Row{"nurbs", "u1", "0.6", patch},
    Row{"nurbs", "v0", "0.3", patch},
    Row{"nurbs", "v1", "0.6", patch},
    Row{"nurbs", "P", "-1 -1 0 0 -1 0 1 -1 0 -1 0 0 0 0 1 1 0 0 -1 1 0 0 1 0 1 1 0", patch},
    Row{"nurbs", "Pw",
        "-1 -1 0 1 0 -1 0 1 1 -1 0 1 -1 0 0 1 0 0 3 3 1 0 0 1 -1 1 0 1 0 1 0 1 1 1 0 1",
        patch_knots,
        "-1 -1 0 1 0 -1 0 1 1 -1 0 1 -1 0 0 1 0 0 1 1 1 0 0 1 -1 1 0 1 0 1 0 1 1 1 0 1"},
};

}  // namespace

std::span<const Row> shape_rows() {
    return shapes;
}

}  // namespace etalon::test
