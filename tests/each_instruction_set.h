// Runs tests with each instruction set for which code is compiled.
#pragma once

#include <hwy/highway.h>

#include "tests/catch.h"

namespace etalon::test {

/// Calls body() once for each instruction set for which the code is compiled and which this machine
/// has, with that one in use.
template <class Body>
void for_each_target(const Body& body) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        INFO(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        body();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace etalon::test
