// Animated transforms.
#include "core/scene/animated_transform.h"

#include "core/numerics/random.h"
#include "core/numerics/transforms.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

double difference(const Affine& a, const Affine& b) {
    return std::max(
        {max_abs(a.x - b.x), max_abs(a.y - b.y), max_abs(a.z - b.z), max_abs(a.origin - b.origin)});
}

Affine any_map(Random& random, double most_degrees) {
    Affine map = rotation(random.uniform(-most_degrees, most_degrees), random.direction()) *
                 scaling({random.uniform(0.2, 4), random.uniform(0.2, 4), random.uniform(0.2, 4)});
    map.origin = 5.0 * random.in_cube();
    return map;
}

}  // namespace

TEST_CASE("MotionTimes: given times of a motion and a shutter, then the part that is done") {
    constexpr ShutterTime middle = ShutterTime{1} << 23;
    CHECK(MotionTimes{}.part(0) == 0);
    CHECK(MotionTimes{}.part(middle) == 0.5);
    CHECK(MotionTimes{}.part(last_shutter_time) == 1 - 0x1p-24);
    const MotionTimes late{1, 3, 2, 6};  // half is done when the shutter opens
    CHECK(late.part(0) == 0.5);
    CHECK(late.part(middle / 4) == 0.75);
    CHECK(late.part(middle) == 1);
    CHECK((late.see_motion() && !MotionTimes{0, 1, 2, 3}.see_motion()));
    CHECK(MotionTimes{1, 1, 0, 2}.part(middle) == 0);
    CHECK(MotionTimes{1, 1, 0, 2}.part(middle + 1) == 1);
    CHECK((shutter_time(0) == 0 && shutter_time(0.5) == middle));
    CHECK(shutter_time(std::nextafter(1.0, 0.0)) == last_shutter_time);
}

TEST_CASE("AnimatedTransform: given two maps, then it goes from the one to the other") {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Affine start = any_map(random, 180), end = any_map(random, 180);
        const AnimatedTransform motion(start, end, {});
        CAPTURE(i);
        REQUIRE((motion.at_part(0) == start && motion.at_part(1) == end));
        REQUIRE((motion.at_part(-1) == start && motion.at_part(2) == end));
        REQUIRE(difference(motion.at_part(0x1p-50), start) < 1e-13);
        REQUIRE(difference(motion.at_part(1 - 0x1p-50), end) < 1e-13);
        const Vec3 middle = motion.at_part(0.5).origin;
        REQUIRE(max_abs(middle - (start.origin + end.origin) / 2) < 1e-14);
        REQUIRE(motion.origin_at(ShutterTime{1} << 23) == middle);
    }
}

TEST_CASE("AnimatedTransform: given a rotation, then it turns at constant speed") {
    const Vec3 axis(1, -2, 3);
    for (const double degrees : {1.0, 20.0, 90.0, 179.0}) {
        const AnimatedTransform motion(rotation(10, axis), rotation(10 + degrees, axis), {});
        for (double part = 0.125; part < 1; part += 0.125) {
            CAPTURE(degrees, part);
            // Below 4 degrees rotation is interpolated along the chord, which is faster in the
            // middle, as in pbrt-v3.
            const double tolerance = degrees < 4 ? 1e-6 : 1e-14;
            CHECK(difference(motion.at_part(part), rotation(10 + part * degrees, axis)) <
                  tolerance);
        }
    }
}

TEST_CASE("AnimatedTransform: given more than half a turn, then it rotates the shorter way") {
    const AnimatedTransform motion(Affine{}, rotation(300, {0, 0, 1}), {});
    CHECK(difference(motion.at_part(0.5), rotation(-30, {0, 0, 1})) < 1e-14);
}

TEST_CASE("AnimatedTransform: given maps that mirror, then it mirrors at all times") {
    const Affine mirror = scaling({-1, 1, 1});
    const AnimatedTransform motion(mirror, rotation(80, {0, 0, 1}) * mirror, {});
    for (double part = 0; part <= 1; part += 0.125) {
        CHECK(difference(motion.at_part(part), rotation(80 * part, {0, 0, 1}) * mirror) < 1e-14);
    }
}

TEST_CASE("AnimatedTransform: given a translation, then nothing else changes by a bit") {
    Random random(2);
    const Affine start = any_map(random, 180);
    Affine end = start;
    end.origin = {7, 8, 9};
    const AnimatedTransform motion(start, end, {});
    CHECK(motion.is_translation());
    Affine middle = motion.at_part(0.5);
    CHECK(middle.origin == (start.origin + end.origin) / 2);
    middle.origin = start.origin;
    CHECK(middle == start);
}

TEST_CASE("AnimatedTransform: given a scale by a power of two, then maps have the same bits") {
    Random random(3);
    const AnimatedTransform motion(any_map(random, 180), any_map(random, 180), {});
    const double k = 0x1p-20;
    const AnimatedTransform small = motion.after(k, Vec3(0));
    for (double part = 0; part <= 1; part += 0.125) {
        const Affine a = motion.at_part(part), b = small.at_part(part);
        CHECK(b == Affine{k * a.x, k * a.y, k * a.z, k * a.origin});
    }
}

TEST_CASE("AnimatedTransform: given a slice of the time, then no point leaves its chord by more") {
    Random random(4);
    double tightest = 0;
    for (int i = 0; i < 2000; ++i) {
        const double most = i % 2 == 0 ? 180 : 3.5;
        const Affine start = any_map(random, most);
        const AnimatedTransform motion(start, any_map(random, most), {});
        const Vec3 a = 3.0 * random.in_cube(), b = 3.0 * random.in_cube();
        Box3 box(a);
        box.extendBy(b);
        const double length = 1.0 / 32, first = random.uniform(0, 1 - length);
        const double bound = motion.deviation(box, length);
        const Vec3 p = a + (b - a) * Vec3(random.uniform(0, 1), random.uniform(0, 1), 1);
        const Vec3 from = motion.at_part(first).point(p);
        const Vec3 to = motion.at_part(first + length).point(p);
        for (double s = 0.125; s < 1; s += 0.125) {
            const Vec3 chord = (1 - s) * from + s * to;
            const double leaves = (motion.at_part(first + s * length).point(p) - chord).length();
            CAPTURE(i, s, bound);
            REQUIRE(leaves <= bound);
            tightest = std::max(tightest, leaves / bound);
        }
    }
    CHECK(tightest > 0.5);
}
