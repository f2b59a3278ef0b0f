// main() of every test program.
#define CATCH_CONFIG_RUNNER
#include "tests/catch.h"

/// Exit status of a run in which nothing failed but some test case was skipped;
/// tests/CMakeLists.txt tells it to ctest.
constexpr int exit_skipped = 77;

int main(int argc, char** argv) {
    const int failures = Catch::Session().run(argc, argv);
    if (failures != 0) return 1;
    return etalon::test::skipped_cases > 0 ? exit_skipped : 0;
}
