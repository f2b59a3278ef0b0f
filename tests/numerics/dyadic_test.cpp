#include "core/numerics/dyadic.h"

#include "core/numerics/exact.h"
#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/numerics/long_sum.h"

using namespace etalon;

namespace {

/// Returns a number of either sign with a magnitude between 2^-reach and 2^reach.
double any_number(int reach, Random& random) {
    const int exponent = static_cast<int>(random.index(2 * reach)) - reach;
    return std::ldexp(random.uniform(-1, 1), exponent);
}

double value(const Dyadic& x) {
    return x.sign() * static_cast<double>(x.magnitude());
}

}  // namespace

TEST_CASE("Dyadic: given any double, then its value is that double") {
    Random random(20261121);
    for (int i = 0; i < 10000; ++i) {
        const double x = any_number(1023, random);
        REQUIRE(value(Dyadic(x)) == x);
        REQUIRE(value(-Dyadic(x)) == -x);
    }
    for (const double x : {0.0, 1.0, 0x1p-1074, 0x1.fffffffffffffp1023, -0x1p64, 0x1p-64}) {
        REQUIRE(value(Dyadic(x)) == x);
    }
}

TEST_CASE("Dyadic: given a sum or a product of two doubles, then it is rounded once") {
    Random random(20261121);
    for (int i = 0; i < 100000; ++i) {
        const double a = any_number(100, random), b = any_number(100, random);
        REQUIRE(value(Dyadic(a) + Dyadic(b)) == a + b);
        REQUIRE(value(Dyadic(a) - Dyadic(b)) == a - b);
        REQUIRE(value(Dyadic(a) * Dyadic(b)) == a * b);
        REQUIRE(value(Dyadic(a) * Dyadic(b) - Dyadic(a * b)) == two_product(a, b).error);
        REQUIRE(value(Dyadic(a) + Dyadic(b) - Dyadic(a + b)) == two_sum(a, b).error);
    }
}

TEST_CASE("Dyadic: given products of three that cancel, then the sign is the true one") {
    Random random(20261121);
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        LongSum expected;
        Dyadic sum;
        const double a = any_number(200, random), b = any_number(200, random);
        const double c = random.uniform(-1, 1);
        const double other = i % 3 == 0 ? c : std::nextafter(c, i % 3 - 1.5);
        for (const auto& [x, y, z] :
             {std::array{a, b, c}, std::array{-b, other, a}, std::array{i % 2 * 0x1p-600, a, b}}) {
            expected.add(x, y, z);
            sum = sum + Dyadic(x) * Dyadic(y) * Dyadic(z);
        }
        REQUIRE(sum.sign() == expected.sign());
        zeros += sum.sign() == 0;
    }
    REQUIRE(zeros > 1000);
}

TEST_CASE("Dyadic: given the widest numbers there are, then twelve factors have room") {
    const Dyadic widest = Dyadic(0x1.fffffffffffffp1023) - Dyadic(-0x1p-1074);
    Dyadic product(1), other(1);
    for (int i = 0; i < 12; ++i) {
        product = product * widest;
        other = widest * other;
    }
    REQUIRE((product - other).sign() == 0);
    REQUIRE((product + other - Dyadic(1)).sign() == 1);
    // (x + 1)(x - 1) = x^2 - 1
    const Dyadic one(1), six = square(widest) * square(widest) * square(widest);
    REQUIRE(((six + one) * (six - one) - square(six) + one).sign() == 0);
    REQUIRE((square(six) - (six + one) * (six - one)).magnitude().mantissa > 0);
}

TEST_CASE("WideDouble: given numbers beyond the range of double, then ratios and roots are right") {
    const Dyadic large(0x1p1000), small(0x1p-1000);
    const WideDouble beyond = square(large).magnitude(), below = (square(small)).magnitude();
    REQUIRE(static_cast<double>(square_root(beyond)) == 0x1p1000);
    REQUIRE(static_cast<double>(square_root(below)) == 0x1p-1000);
    REQUIRE(static_cast<double>(beyond / (square(large) * Dyadic(3)).magnitude()) == 1.0 / 3);
    REQUIRE(static_cast<double>((beyond + below) / beyond) == 1);
    REQUIRE(static_cast<double>((below + WideDouble{}) / below) == 1);
    REQUIRE(static_cast<double>(square_root((Dyadic(2) * small).magnitude())) ==
            std::sqrt(0x1p-999));
}
