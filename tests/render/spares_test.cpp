#include "core/parallel/spares.h"

#include <stdexcept>

#include "tests/catch.h"

using namespace etalon;

TEST_CASE("Spares: an object is lent again as it was left", "[parallel]") {
    Spares<int> spares;
    {
        const auto first = spares.lend(1), second = spares.lend(2);
        CHECK((*first == 1 && *second == 2));
        *second = 5;
    }
    const auto one = spares.lend(3), other = spares.lend(4), third = spares.lend(7);
    CHECK((*one + *other == 6 && *third == 7));
}

TEST_CASE("Spares: an object whose use an exception ended is not lent again", "[parallel]") {
    Spares<int> spares;
    const auto use = [&](bool fails) {
        const auto loan = spares.lend(1);
        *loan = 2;
        if (fails) throw std::runtime_error("half changed");
    };
    CHECK_THROWS(use(true));
    CHECK(*spares.lend(1) == 1);
    use(false);
    CHECK(*spares.lend(1) == 2);
}
