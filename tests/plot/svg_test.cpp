#include "bench/plot/svg.h"

#include "tests/catch.h"
#include "tests/markup.h"

using namespace etalon::plot;

TEST_CASE("An image in a file of its own needs no variables of CSS, which few viewers know") {
    Svg svg(20, 10, "title", "description");
    svg.dot({5, 5}, 3, "hint", "mark c2 hollow");
    const std::string file = svg.standalone();
    CHECK(etalon::test::is_well_formed(file));
    CHECK_THAT(file, !ContainsSubstring("var(") && !ContainsSubstring("--"));
    CHECK_THAT(file,
               ContainsSubstring(".c2{color:#d55e00}") && ContainsSubstring(".hollow{fill:#fff}"));
    CHECK_THAT(svg.inlined(), !ContainsSubstring("<style>"));
}
