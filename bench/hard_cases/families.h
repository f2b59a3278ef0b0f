// The catalogue's parts. A new shape's rows are one more of these, joined in hard_case.cpp.
#pragma once

#include "bench/hard_cases/hard_case.h"

namespace etalon::hard {

std::vector<HardCase> sphere_cases();
std::vector<HardCase> shell_cases();
std::vector<HardCase> mesh_cases();

}  // namespace etalon::hard
