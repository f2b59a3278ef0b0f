// Two ways to find the lowest lane of a mask. A traversal tests a node's boxes, learns from the
// mask which child comes next, and only then can fetch it. Selecting the lane by branches gives the
// same result, but lets the processor predict: where it predicts right, the next node is fetched
// before this one's boxes are tested; where it is wrong, work is lost.
#pragma once

#include <bit>
#include <cstdint>

namespace etalon {

/// Computes the lane from the mask.
struct BranchlessLaneSelect {
    static int of(std::uint32_t mask) { return std::countr_zero(mask); }
};

/// Selects the lane by branches, for rays that take the same path as those before them.
struct BranchingLaneSelect {
    static int of(std::uint32_t mask) {
        switch (std::countr_zero(mask)) {
            case 0:
                return constant<0>();
            case 1:
                return constant<1>();
            case 2:
                return constant<2>();
            case 3:
                return constant<3>();
            case 4:
                return constant<4>();
            case 5:
                return constant<5>();
            case 6:
                return constant<6>();
            default:
                return constant<7>();
        }
    }

  private:
    /// Hides the constant from the compiler, which would otherwise compute the lane after all.
    template <int lane>
    static int constant() {
        int result = lane;
        asm volatile("" : "+r"(result));
        return result;
    }
};

}  // namespace etalon
