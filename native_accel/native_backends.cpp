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
    {.name = "none",
     .summary = "tests every primitive for every ray: the reference",
     .exact = true,
     .build = build<None>,
     .counts_box_tests = true,
     .counts_primitive_tests = true},
    {.name = "grid",
     .summary = "nested grids, traversed by a 3D-DDA",
     .exact = true,
     .build = build<Grid>,
     .counts_box_tests = true,
     .counts_primitive_tests = true,
     .colour = 3},
    {.name = "bvh",
     .summary = "bounding volume hierarchy by binned SAH, eight-wide",
     .exact = true,
     .build = build<Bvh>,
     .counts_box_tests = true,
     .counts_primitive_tests = true,
     .colour = 1},
};

}  // namespace

std::span<const Backend> native_backends() {
    return backends;
}

}  // namespace etalon
