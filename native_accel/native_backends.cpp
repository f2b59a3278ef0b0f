#include "native_accel/native_backends.h"

#include "native_accel/bvh/bvh.h"
#include "native_accel/grid/grid.h"
#include "native_accel/none.h"

namespace etalon {
namespace {

template <class Accelerator>
std::unique_ptr<Intersector> build(const Geometry& geometry) {
    return std::make_unique<Accelerator>(geometry);
}

constexpr Backend backends[] = {
    {"none", "tests every primitive for every ray: the reference", true, build<None>, true, true},
    {"grid", "nested grids, traversed by a 3D-DDA", true, build<Grid>, true, true, 3},
    {"bvh", "bounding volume hierarchy by binned SAH, eight-wide", true, build<Bvh>, true, true, 1},
};

}  // namespace

std::span<const Backend> native_backends() {
    return backends;
}

}  // namespace etalon
