// Catch2 2.13 (Debian 12) and 3 (Debian 13) from one source, and skipping for both.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>
inline auto ContainsSubstring(const std::string& part) {
    return Catch::Matchers::Contains(part);
}
#endif

namespace etalon::test {

/// Number of test cases of this process that were skipped; main() turns it into an exit status.
inline int skipped_cases = 0;

}  // namespace etalon::test

/// Ends a test case, as skipped, on a machine that does not meet `condition`. The case must have a
/// tag [needs_...], by which it is a test of its own for ctest, which reports it as skipped.
/// Earlier failures of the same run remain failures.
#define SKIP_UNLESS(condition, reason)     \
    do {                                   \
        if (!(condition)) {                \
            ++etalon::test::skipped_cases; \
            WARN("skipped: " << reason);   \
            return;                        \
        }                                  \
    } while (false)
