#include "core/scene/instance.h"

#include <cmath>
#include <optional>

#include "core/numerics/random.h"
#include "core/numerics/rounding.h"
#include "core/numerics/transforms.h"
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

/// Returns a map between two rotations or shears, of a condition number of up to 10^16.
Affine ill_conditioned_map(Random& random) {
    const auto size = [&] { return random.magnitude(random.one_in(2) ? -8 : 0, 0); };
    const auto turn = [&] {
        if (random.one_in(4))
            return Affine{{1, 0, 0}, {1 / size(), 1, 0}, {0, 1 / size(), 1}, Vec3(0)};
        return rotation(random.uniform(0, 360), random.direction());
    };
    return turn() * scaling({size(), -1, size()}) * turn();
}

/// An instance's matrix, by columns, for inverse_at().
Affine matrix_of(const Instance& instance) {
    const auto& [a, b, c] = instance.rows;
    return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, {}};
}

/// Returns |X| |A| v for v = (1, 1, 1), where X is the inverse of the matrix A: the spread.
Vec3 spread_of(const Affine& matrix) {
    const Vec3 once = abs(matrix.x) + abs(matrix.y) + abs(matrix.z);
    Vec3 spread(0);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            spread[i] += std::abs(static_cast<double>(inverse_at(matrix, i, j))) * once[j];
        }
    }
    return spread;
}

/// Returns how far the image of `v` under a map is from that under the inverse of the matrix, in
/// units of the spread and of the image's size.
double error_of_image(const Affine& matrix, const Affine& map, const Vec3& v) {
    const std::array<Vec3, 3> columns = {map.x, map.y, map.z};
    Vec3 image, error;
    for (int i = 0; i < 3; ++i) {
        Quad exact = 0, found = 0;
        for (int j = 0; j < 3; ++j) {
            exact += inverse_at(matrix, i, j) * Quad(v[j]);
            found += Quad(columns[static_cast<std::size_t>(j)][i]) * Quad(v[j]);
        }
        image[i] = static_cast<double>(exact);
        error[i] = static_cast<double>(found - exact);
    }
    return max_abs(error / spread_of(matrix)) / max_abs(image);
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
    const Vec3 x(1, 2, 3), y(4, 5, 6), origin(0);
    CHECK(Instance({x, y, Vec3(0, 0, 1), origin}, 0).exists());
    CHECK_FALSE(Instance({x, y, x + y, origin}, 0).exists());
    CHECK_FALSE(Instance({x, y, Vec3(0), origin}, 0).exists());
    CHECK_FALSE(Instance({x, y, Vec3(infinity, 0, 0), origin}, 0).exists());
    CHECK_FALSE(Instance({x, y, Vec3(nan_value, 0, 0), origin}, 0).exists());
}

TEST_CASE(
    "An instance's precise map is off by roundings, or there is none and the spread is large") {
    Random random(9, 0);
    int precise = 0, none = 0;
    for (int i = 0; i < 4000; ++i) {
        const Instance instance(ill_conditioned_map(random), 0);
        const std::optional<Affine> map = instance.precise_to_world();
        CAPTURE(i);
        if (map) {
            const double error = error_of_image(matrix_of(instance), *map, random.direction());
            REQUIRE(error <= 25 * unit_roundoff);
            ++precise;
        } else {
            REQUIRE(max_abs(spread_of(matrix_of(instance))) > 0x1p21);
            ++none;
        }
    }
    CHECK(precise > 1000);
    CHECK(none > 100);
}
