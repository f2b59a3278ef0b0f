#include "core/intersect/shapes/exact_quadratic.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr int in = ExactQuadratic::in, out = ExactQuadratic::out;

/// 2 a (t - p) (t - q)
ExactQuadratic with_roots(double a, double p, double q) {
    return {Dyadic(2 * a), Dyadic(-a * (p + q)), Dyadic(2 * a * p * q)};
}

int sign(double x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

double small(Random& random) {
    return static_cast<double>(random.index(9)) - 4;
}

}  // namespace

TEST_CASE("ExactQuadratic: given integer roots, then the form falls at `in` and rises at `out`") {
    for (const double a : {1.0, 3.0, -1.0, -5.0}) {
        const ExactQuadratic form = with_roots(a, -2, 7);
        REQUIRE(form.has_roots());
        REQUIRE(form.opening() == sign(a));
        REQUIRE(form.root(in) == (a > 0 ? -2 : 7));
        REQUIRE(form.root(out) == (a > 0 ? 7 : -2));
    }
}

TEST_CASE("ExactQuadratic: given a plane, then its side is that of the root as a number") {
    Random random(40);
    for (int i = 0; i < 20000; ++i) {
        const double a = random.sign() * (1 + static_cast<double>(random.index(3)));
        const double p = small(random), q = small(random);
        const double start = small(random), rise = small(random);
        const ExactQuadratic form = with_roots(a, p, q);
        const double first = std::min(p, q), last = std::max(p, q);
        CAPTURE(a, p, q, start, rise);
        const auto side = [&](int way) {
            return form.sign_at_root(way, Dyadic(start), Dyadic(rise));
        };
        REQUIRE(side(in) == sign(start + rise * (a > 0 ? first : last)));
        REQUIRE(side(out) == sign(start + rise * (a > 0 ? last : first)));
    }
}

TEST_CASE(
    "ExactQuadratic: given roots that no double can tell from a plane, then sides are right") {
    // t^2 = 1 -+ 2^-160 against t = 1 and t = -1.
    const Dyadic one(1), tiny(0x1p-160);
    const Dyadic rise = Dyadic(0x1p1000) * Dyadic(0x1p1000);
    for (const double k : {1.0, -1.0}) {
        const ExactQuadratic form(one, Dyadic(0), Dyadic(k) * tiny - one);
        REQUIRE(form.root(out) == 1);
        REQUIRE(form.sign_at_root(out, -rise, rise) == -sign(k));
        REQUIRE(form.sign_at_root(in, rise, rise) == sign(k));
    }
}

TEST_CASE("ExactQuadratic: given no roots, or no unknown, then it reports none") {
    const auto has_roots = [](double a, double b, double c) {
        return ExactQuadratic(Dyadic(a), Dyadic(b), Dyadic(c)).has_roots();
    };
    REQUIRE(has_roots(1, 2, 4));
    REQUIRE_FALSE(has_roots(1, 2, std::nextafter(4, 5)));
    REQUIRE_FALSE(has_roots(0, 0, -1));
    REQUIRE_FALSE(has_roots(0, 0, 0));
    REQUIRE(has_roots(0, 1, 8));
    REQUIRE(ExactQuadratic(Dyadic(0), Dyadic(1), Dyadic(8)).root(out) == -4);
}
