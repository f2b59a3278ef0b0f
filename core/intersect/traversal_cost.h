#pragma once

#include <cstdint>

namespace etalon {

/// Work to find the nearest hit of a ray: a measure of an accelerator that depends neither on the
/// machine nor on its load.
struct TraversalCost {
    std::uint64_t box_tests = 0;        ///< tests of boxes, and grid cells visited
    std::uint64_t primitive_tests = 0;  ///< calls of a kernel, or of a filter in front of it
};

}  // namespace etalon
