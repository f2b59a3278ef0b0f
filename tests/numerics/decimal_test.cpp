#include "core/numerics/decimal.h"

#include <bit>
#include <charconv>
#include <limits>
#include <string>

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

double parsed(const std::string& text) {
    double x = 0;
    std::from_chars(text.data(), text.data() + text.size(), x);
    return x;
}

/// Returns whether the number is stored without a change of its bits.
bool is_kept(double x) {
    const std::optional<Decimal> d = Decimal::from(x);
    return d && std::bit_cast<std::uint64_t>(d->value()) == std::bit_cast<std::uint64_t>(x);
}

}  // namespace

TEST_CASE("Decimal: given numbers of seven digits as text, then each is kept to the bit") {
    Random random(1, 0);
    for (int i = 0; i < 300'000; ++i) {
        const std::size_t digits = random.index(10'000'000);
        const int power = static_cast<int>(random.index(16));
        std::string text = std::to_string(digits) + "e-" + std::to_string(power);
        if (i % 2 != 0) text.insert(text.begin(), '-');
        CAPTURE(text);
        if (digits == 0 && i % 2 != 0) continue;
        REQUIRE(is_kept(parsed(text)));
    }
}

TEST_CASE("Decimal: given any double, then it is kept to the bit or refused") {
    Random random(2, 0);
    int refused = 0;
    for (int i = 0; i < 300'000; ++i) {
        const double x =
            random.uniform(-1, 1) * std::exp2(static_cast<double>(random.index(80)) - 50);
        refused += Decimal::from(x).has_value() ? 0 : 1;
        if (Decimal::from(x)) REQUIRE(is_kept(x));
    }
    CHECK(refused > 290'000);
}

TEST_CASE("Decimal: given what it has no form for, then it is refused") {
    const double most = std::numeric_limits<double>::max();
    for (const double x :
         {-0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          most, 0x1p26, -0x1p26, 1e-30, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(x);
        CHECK_FALSE(Decimal::from(x));
    }
    CHECK(is_kept(0.0));
    CHECK(is_kept(0x1p26 - 1));
    CHECK(is_kept(1e-22));
    CHECK(is_kept(-9.01e-05));
}
