#pragma once

#include <cstdint>

namespace etalon {

/// Work of finding the nearest hit of a ray: a measure of an accelerator that no machine and
/// no other load on it changes.
struct TraversalCost {
    std::uint64_t box_tests = 0;        ///< of boxes, and cells of grids gone through
    std::uint64_t primitive_tests = 0;  ///< by a kernel, or by a filter in front of it
};

}  // namespace etalon
