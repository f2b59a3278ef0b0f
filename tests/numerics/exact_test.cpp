#include "core/numerics/exact.h"

#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/numerics/long_sum.h"

using namespace etalon;

namespace {

int sign(double x) {
    return (x > 0) - (x < 0);
}

/// Returns `v` with every component changed by up to `ulps` steps.
Vec3 nudged(Vec3 v, int ulps, Random& random) {
    for (int k = 0; k < 3; ++k) v[k] *= 1 + 0x1p-52 * std::round(random.uniform(-ulps, ulps));
    return v;
}

/// The sign of d . ((a - o) x (b - o)), multiplied out: 18 products of three doubles.
int true_sign(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b) {
    LongSum sum;
    const auto add_determinant = [&](const Vec3& p, const Vec3& q, double factor) {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            sum.add(factor * d[i], p[j], q[k]);
            sum.add(-factor * d[i], p[k], q[j]);
        }
    };
    add_determinant(a, b, 1);
    add_determinant(a, o, -1);
    add_determinant(o, b, -1);
    return sum.sign();
}

struct EdgeCase {
    Vec3 o, d, a, b;
};

/// Rays aimed at a point of an edge, as exactly as doubles allow, so that the volume nearly
/// vanishes.
EdgeCase nearly_coplanar(Random& random, double distance) {
    EdgeCase c;
    c.a = random.in_cube();
    c.b = random.in_cube();
    c.o = distance * random.in_cube();
    const Vec3 target = c.a + random.uniform(0, 1) * (c.b - c.a);
    c.d = nudged(target - c.o, 1, random);
    return c;
}

}  // namespace

TEST_CASE("LongSum: given sums that cancel, then the sign is that of what is left") {
    LongSum sum;
    REQUIRE(sum.sign() == 0);
    sum.add(1e30, 1e30, 1e30);
    sum.add(0x1p-300, -0x1p-300, 0x1p-300);
    REQUIRE(sum.sign() == 1);
    sum.add(-1e30, 1e30, 1e30);
    REQUIRE(sum.sign() == -1);
    sum.add(0x1p-300, 0x1p-300, 0x1p-300);
    REQUIRE(sum.sign() == 0);
    sum.add(-1 - 0x1p-52, 1 + 0x1p-52, 1);
    sum.add(1, 1, 1 + 0x1p-51);
    REQUIRE(sum.sign() == -1);  // the square's last term
}

TEST_CASE("two_sum and two_product: given any operands, then value + error is exact") {
    Random random(20260129);
    for (int i = 0; i < 100000; ++i) {
        const double a = random.in_cube().x, b = std::ldexp(random.in_cube().x, i % 120 - 60);
        const TwoTerm s = two_sum(a, b), p = two_product(a, b);
        LongSum sum, product;
        for (const double x : {a, b, -s.value, -s.error}) sum.add(x, 1, 1);
        product.add(a, b, 1);
        for (const double x : {p.value, p.error}) product.add(-x, 1, 1);
        REQUIRE(sum.sign() == 0);
        REQUIRE(product.sign() == 0);
        REQUIRE(s.value == a + b);
        REQUIRE(std::abs(p.error) <= std::abs(p.value) * 0x1p-53);
    }
}

TEST_CASE(
    "exact_edge_volume: given nearly coplanar rays and edges, then the sign is the true one") {
    Random random(20260129);
    int zeros = 0, wrong_in_double = 0;
    for (int i = 0; i < 20000; ++i) {
        const EdgeCase c = nearly_coplanar(random, std::pow(10.0, i % 9));
        const int expected = true_sign(c.o, c.d, c.a, c.b);
        REQUIRE(sign(exact_edge_volume(c.o, c.d, c.a, c.b)) == expected);
        const double plain = c.d.dot((c.a - c.o).cross(c.b - c.o));
        zeros += expected == 0;
        wrong_in_double += sign(plain) != expected;
    }
    INFO(zeros << " exact zeros, " << wrong_in_double << " that plain double gets wrong");
    REQUIRE(wrong_in_double > 1000);  // otherwise the test proves nothing
}

TEST_CASE("exact_edge_volume: given a ray through a corner or along an edge, then it is zero") {
    Random random(20260129);
    for (int i = 0; i < 1000; ++i) {
        // Few bits, so that the differences are exact and the ray truly passes through a.
        const auto coarse = [&] { return Vec3(Imath::V3f(random.in_cube())); };
        const Vec3 a = coarse(), b = coarse(), d = coarse();
        REQUIRE(exact_edge_volume(a - 0.5 * d, d, a, b) == 0);
        REQUIRE(exact_edge_volume(a, d, a, b) == 0);
        REQUIRE(exact_edge_volume(d, b - a, a, a) == 0);
    }
}

TEST_CASE(
    "exact_edge_volume: given the edge's other direction, then every bit is the same but the "
    "sign") {
    Random random(20260129);
    for (int i = 0; i < 20000; ++i) {
        const EdgeCase c = nearly_coplanar(random, std::pow(10.0, i % 9));
        REQUIRE(exact_edge_volume(c.o, c.d, c.a, c.b) == -exact_edge_volume(c.o, c.d, c.b, c.a));
    }
}

TEST_CASE("shear_sign: given products that nearly cancel, then the sign is the true one") {
    Random random(20260129);
    int wrong_in_double = 0;
    for (int i = 0; i < 50000; ++i) {
        const double a = random.in_cube().x, b = random.in_cube().x, c = random.in_cube().x;
        const double e = random.in_cube().x, y = random.in_cube().x;
        const double x = y * (c - e) / (a - b) * (1 + 0x1p-52 * (i % 3 - 1));
        LongSum sum;
        sum.add(x, a, 1);
        sum.add(-x, b, 1);
        sum.add(-y, c, 1);
        sum.add(y, e, 1);
        REQUIRE(sign(shear_sign(x, a, b, y, c, e)) == sum.sign());
        wrong_in_double += sign(x * (a - b) - y * (c - e)) != sum.sign();
    }
    REQUIRE(wrong_in_double > 1000);
}

TEST_CASE("Exact signs: given a product below the range of double that decides, then it does") {
    // All other terms cancel.
    const double slow = 0x1p-400;
    for (const double near : {0x1p-900, -0x1p-900}) {
        const int expected = near > 0 ? 1 : -1;
        const Vec3 o(-slow, -1, near), d(slow, 1, 0), a(0), b(0, 1, 1);
        CHECK(sign(exact_edge_sign(o, d, a, b)) == expected);
        CHECK(sign(exact_edge_volume(o, d, a, b)) == expected);
        CHECK(sign(exact_edge_volume(o, d, b, a)) == -expected);
        CHECK(sign(exact_dot({1, slow, 0}, {0, 1, 0}, {slow, near, 0})) == -expected);
        CHECK(sign(shear_sign(slow, 1, near, 1, 0, -slow)) == -expected);
        CHECK(sign(shear_sign(1, 0, -slow, slow, 1, near)) == expected);
    }
}

TEST_CASE(
    "Expansion: given a value split over many terms, then the estimate is its nearest double") {
    Random random(20260129);
    for (int i = 0; i < 2000; ++i) {
        const double value = random.in_cube().x;
        Expansion<64> sum;
        for (int k = 0; k < 30; ++k) {
            const double noise = std::ldexp(random.in_cube().x, k * 9 - 100);
            sum.add(noise);
            if (k == 17) sum.add(value);
            sum.add(-noise);
        }
        REQUIRE(sum.estimate() == value);
        sum.add(-value);
        REQUIRE(sum.estimate() == 0);
    }
}

TEST_CASE("exact_edge_volume: given a number that is none, then the result is none either") {
    const std::array<Vec3, 4> generic = {Vec3(1, 2, 3), Vec3(3, 1, 2), Vec3(5, 4, 1),
                                         Vec3(1, 1, 2)};
    const std::array<Vec3, 4> flat = {Vec3(0, 0, 2), Vec3(1, 1, 0), Vec3(4, 0, 2), Vec3(0, 4, 2)};
    for (const double bad : {nan_value, infinity, -infinity}) {
        for (int k = 0; k < 24; ++k) {
            std::array<Vec3, 4> v = k < 12 ? generic : flat;
            v[static_cast<std::size_t>(k / 3 % 4)][k % 3] = bad;
            CAPTURE(bad, k);
            REQUIRE(!std::isfinite(exact_edge_volume(v[0], v[1], v[2], v[3])));
        }
    }
}
