#include "tests/intersect/shape_cases.h"

#include "tests/intersect/shapes/families.h"

namespace etalon {

std::vector<ShapeCase> shape_cases() {
    std::vector<ShapeCase> cases;
    for (Family* const family : families) {
        for (ShapeCase& c : family()) cases.push_back(std::move(c));
    }
    return cases;
}

}  // namespace etalon
