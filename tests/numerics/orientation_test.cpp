#include "core/numerics/orientation.h"

#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/numerics/long_sum.h"

using namespace etalon;

namespace {

int sign(double x) {
    return (x > 0) - (x < 0);
}

/// The sign of (b - a) x (c - a), multiplied out.
int true_sign(const Vec2& a, const Vec2& b, const Vec2& c) {
    LongSum sum;
    const auto add_cross = [&](const Vec2& p, const Vec2& q) {
        sum.add(1, p.x, q.y);
        sum.add(-1, p.y, q.x);
    };
    add_cross(a, b);
    add_cross(b, c);
    add_cross(c, a);
    return sum.sign();
}

}  // namespace

TEST_CASE("the orientation of three nearly collinear points has the exact sign") {
    Random random(7);
    const auto point = [&] { return Vec2(random.uniform(-1, 1), random.uniform(-1, 1)); };
    std::array<int, 3> seen{};
    for (int i = 0; i < 20000; ++i) {
        const Vec2 a = point(), b = point();
        Vec2 c = a + random.uniform(-2, 2) * (b - a);
        if (i % 4 == 0) c = a + 0.5 * (b - a);
        for (const double scale : {1.0, 0x1p-600}) {
            const int expected = true_sign(a, b, c);
            CHECK(sign(orientation(scale * a, scale * b, scale * c)) == expected);
            ++seen[static_cast<std::size_t>(expected + 1)];
        }
    }
    for (const int count : seen) CHECK(count > 100);
}

TEST_CASE("the orientation of points that are no triangle is 0") {
    const Vec2 a(0.1, 0.2), b(0.3, 0.2), c(0.7, 0.2);
    for (const auto& [p, q, r] :
         {std::array{a, b, c}, {a, a, b}, {a, b, a}, {b, a, a}, {a, a, a}}) {
        CHECK(orientation(p, q, r) == 0);
    }
}
