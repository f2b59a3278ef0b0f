#include "native_accel/common/isa.h"

#include <algorithm>
#include <cctype>

#include "core/numerics/instruction_sets.h"

#include <hwy/highway.h>

namespace etalon {

std::string traversal_isa() {
    const std::int64_t supported = hwy::SupportedTargets() & HWY_TARGETS;
    std::string name = hwy::TargetName(supported & -supported);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return name;
}

}  // namespace etalon
