#include "core/scene/instance.h"

#include <cmath>

#include "core/numerics/random.h"
#include "core/oracle/quad.h"
#include "tests/catch.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns a number of the inverse of the matrix with the columns of a map.
Quad inverse_at(const Affine& map, int row, int column) {
    const std::array<Vec3, 3> columns = {map.x, map.y, map.z};
    const auto at = [&](int r, int c) {
        return Quad(columns[static_cast<std::size_t>(c % 3)][r % 3]);
    };
    const auto cofactor = [&](int r, int c) {
        return at(r + 1, c + 1) * at(r + 2, c + 2) - at(r + 2, c + 1) * at(r + 1, c + 2);
    };
    const Quad determinant =
        at(0, 0) * cofactor(0, 0) + at(1, 0) * cofactor(1, 0) + at(2, 0) * cofactor(2, 0);
    return cofactor(column, row) / determinant;
}

Affine random_map(Random& random) {
    const auto number = [&] { return random.sign() * random.magnitude(-3, 3); };
    const auto column = [&] { return Vec3(number(), number(), number()); };
    return {column(), column(), column(), column()};
}

}  // namespace

TEST_CASE("The rows of an instance are the inverse of its map, rounded once") {
    Random random(7, 0);
    for (int i = 0; i < 2000; ++i) {
        const Affine map = random_map(random);
        const Instance instance(map, 0);
        CHECK(instance.origin == map.origin);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                const double found = instance.rows[static_cast<std::size_t>(row)][column];
                const Quad expected = inverse_at(map, row, column);
                CAPTURE(i, row, column, found);
                const double error = static_cast<double>(magnitude(found - expected));
                CHECK(error <= 0x1.00000001p-53 * std::abs(found));
            }
        }
    }
}

TEST_CASE("The rows of an instance have the same bits with every instruction set") {
    Random random(8, 0);
    for (int i = 0; i < 300; ++i) {
        Affine map = random_map(random);
        for (Vec3* column : {&map.x, &map.y, &map.z}) *column *= std::ldexp(1.0, 3 * (i - 150));
        const Instance expected(map, 0);
        CAPTURE(i);
        for_each_target([&] { CHECK(Instance(map, 0).rows == expected.rows); });
    }
}

TEST_CASE("An instance of a singular map, or of one that is not finite, does not exist") {
    const Vec3 x(1, 2, 3), y(4, 5, 6);
    CHECK(Instance({x, y, Vec3(0, 0, 1), {}}, 0).exists());
    CHECK_FALSE(Instance({x, y, x + y, {}}, 0).exists());
    CHECK_FALSE(Instance({x, y, Vec3(0), {}}, 0).exists());
    CHECK_FALSE(Instance({x, y, Vec3(infinity, 0, 0), {}}, 0).exists());
    CHECK_FALSE(Instance({x, y, Vec3(nan_value, 0, 0), {}}, 0).exists());
}
