#include "core/diffusion/profile_sampling.h"

#include <numbers>

#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/diffusion/profiles.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const Vec3 position(1, 2, 3);

/// A plane with this normal through the point, hit by probes: estimates the light that leaves at
/// the point under uniform irradiance.
Color light_from_plane(const SpreadProfile& profile, const BsdfFrame& frame, const Vec3& normal) {
    const ProfileSampling sampling(profile, frame, position);
    Random random(5);
    Color sum(0);
    constexpr int samples = 200000;
    for (int i = 0; i < samples; ++i) {
        const double choice = random.uniform(), u = random.uniform(), v = random.uniform();
        const auto probe = sampling.probe(choice, {u, v});
        if (!probe) continue;
        const double t = normal.dot(position - probe->origin) / normal.dot(probe->direction);
        if (!(t >= 0 && t <= probe->length)) continue;
        const Vec3 point = probe->origin + t * probe->direction;
        sum += sampling.value(point) / sampling.density(point, normal);
    }
    return sum / samples;
}

}  // namespace

TEST_CASE("Probes find the light of a plane, whatever the frame", "[diffusion]") {
    const Vec3 up(0, 0, 1), slanted = normalized(Vec3(1, 2, 3));
    const BsdfFrame frame(up, up, Vec3(1, 1, 0));
    for (const auto& [name, profile, albedo] : profiles()) {
        for (const Vec3& normal : {up, slanted}) {
            const Color light = light_from_plane(profile, frame, normal);
            for (int c = 0; c < 3; ++c) {
                INFO(name << ", channel " << c << ", normal " << normal.z);
                // Probes end where a thousandth of a channel's light remains, and earlier for other
                // channels.
                CHECK(light[c] < 1.005 * albedo[c]);
                CHECK(light[c] > (normal == up ? 0.99 : 0.97) * albedo[c]);
            }
        }
    }
}

TEST_CASE("Probes go through the surroundings of a point along three axes", "[diffusion]") {
    const Vec3 up(0, 0, 1);
    const BsdfFrame frame(up, up, Vec3(1, 0, 0));
    const SpreadProfile profile = tabulated();
    const ProfileSampling sampling(profile, frame, position);
    int along[3] = {};
    Random random(2);
    constexpr int samples = 20000;
    int count = 0;
    for (int i = 0; i < samples; ++i) {
        const double choice = random.uniform(), u = random.uniform(), v = random.uniform();
        const auto probe = sampling.probe(choice, {u, v});
        if (!probe) continue;
        ++count;
        ++along[dominant_axis(probe->direction)];
        CHECK(probe->direction.length() == Approx(1));
        // Both ends are equally far away.
        const Vec3 end = probe->origin + probe->length * probe->direction;
        CHECK((end - position).length() == Approx((probe->origin - position).length()));
    }
    CHECK(count > 0.995 * samples);
    CHECK(along[0] == Approx(0.25 * count).epsilon(0.05));
    CHECK(along[1] == Approx(0.25 * count).epsilon(0.05));
    CHECK(along[2] == Approx(0.5 * count).epsilon(0.05));
}
