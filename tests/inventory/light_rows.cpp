#include <array>

#include "tests/inventory/row.h"

namespace etalon::test {
namespace {

constexpr std::array lights = {
    Row{"*", "I", "3 2 1"},
    Row{"*", "L", "3 2 1"},
    Row{"*", "scale", "1 2 3"},
    Row{"*", "from", "0.5 0.2 0.3"},
    Row{"*", "to", "0.5 0.2 1.2"},
    Row{"spot", "coneangle", "20"},
    Row{"spot", "conedeltaangle", "15"},
    Row{"projection", "fov", "25"},
    Row{"*", "mapname", "b.png"},
    Row{"infinite", "samples", "4", "\"string mapname\" \"a.png\""},
};

constexpr std::array area_lights = {
    Row{"diffuse", "L", "3 2 1"},
    Row{"diffuse", "scale", "1 2 3"},
    Row{"diffuse", "twosided", "true"},
    Row{"diffuse", "samples", "4"},
};

}  // namespace

std::span<const Row> light_rows() {
    return lights;
}
std::span<const Row> area_light_rows() {
    return area_lights;
}

}  // namespace etalon::test
