// Lenses of several surfaces: focus and vignetting.
#include <array>
#include <cmath>

#include "core/camera/exit_pupil.h"
#include "core/camera/lens_focus.h"
#include "core/camera/lens_rays.h"
#include "core/sampling/sobol.h"
#include "tests/catch.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double diagonal = 0.04;

constexpr double curvature = 0.05, eta = 1.5, thickness = 0.003, rim = 0.012;

/// A lens of two equal surfaces behind a stop.
LensSystem simple_lens(double stop_radius) {
    return {
        {{0, 0.001, 0, stop_radius}, {curvature, thickness, eta, rim}, {-curvature, 0.05, 1, rim}},
        diagonal,
        {},
        1};
}

/// Such a lens by the equations of thick lenses.
constexpr double focal_length =
    1 / ((eta - 1) * (2 / curvature - (eta - 1) * thickness / (eta * curvature * curvature)));
/// Depth of the principal planes within the lens.
constexpr double depth = focal_length * (eta - 1) * thickness / (curvature * eta);
constexpr double between_planes = thickness - 2 * depth;

LensSystem focused_lens(double stop_radius, double distance) {
    LensSystem lens = simple_lens(stop_radius);
    const Result<LensFocus> focus = focused(lens, distance);
    REQUIRE(focus);
    lens.surfaces.back().thickness = focus.value.film_distance;
    lens.exit_pupils = exit_pupils(lens.surfaces, lens.film_diagonal);
    return lens;
}

}  // namespace

TEST_CASE("A lens focuses by the equation of thick lenses", "[camera]") {
    for (const double distance : {0.25, 1.0, 40.0}) {
        const Result<LensFocus> focus = focused(simple_lens(0.005), distance);
        REQUIRE(focus);
        const double image = focus.value.image_distance, object = distance - between_planes - image;
        CHECK_THAT(1 / image + 1 / object, WithinRel(1 / focal_length, 1e-5));
        CHECK_THAT(focus.value.film_distance, WithinRel(image - depth, 1e-5));
    }
}

TEST_CASE("Some lenses cannot be focused", "[camera]") {
    CHECK(focused(simple_lens(0.005), 0.19).error == "it cannot be focused so near");
    CHECK(focused(simple_lens(0), 1).error == "no light passes along its axis");
    LensSystem concave = simple_lens(0.005);
    for (LensSurface& s : concave.surfaces) s.curvature_radius *= -1;
    CHECK_FALSE(focused(concave, 1));
}

TEST_CASE("Rays of a point of the film meet where the lens is focused", "[camera]") {
    constexpr double distance = 1;
    const LensSystem lens = focused_lens(0.001, distance);
    const LensRays rays(lens, {300, 400});
    const ScrambledSobol points(1);
    std::array<Vec3, 2> sums{Vec3(0), Vec3(0)};
    for (int side = 0; side < 2; ++side) {
        int count = 0;
        for (std::uint32_t i = 0; i < 200; ++i) {
            const WeightedRay r = rays.ray({150, side == 0 ? 190.0 : 200.0}, points(i));
            if (r.weight == 0) continue;
            const auto& [origin, d] = r.ray;
            const Vec3 at = origin + (distance - origin.z) / d.z * d;
            sums[side] += at;
            ++count;
            CHECK(std::hypot(at.x - sums[side].x / count, at.y - sums[side].y / count) < 3e-5);
        }
        REQUIRE(count > 100);
        sums[side] /= count;
    }
    CHECK_THAT(sums[1].y, WithinAbs(0, 1e-6));
    // Ten pixels of .08 mm, magnified; the top of the image is the top of the scene.
    const double image = focused(simple_lens(0.001), distance).value.image_distance;
    const double object = distance - between_planes - image;
    CHECK_THAT(sums[0].y, WithinRel(10 * 0.00008 * object / image, 0.01));
}

TEST_CASE("Exit pupils hold all that comes through a lens, and little else", "[camera]") {
    for (const double stop : {0.0003, 0.004, 0.02}) {
        const LensSystem lens = focused_lens(stop, 2);
        const LensTracer tracer(lens.surfaces);
        REQUIRE(lens.exit_pupils.size() == 64);
        const ScrambledSobol films(2), rears(3);
        const double reach = 1.5 * tracer.rear_radius();
        for (std::uint32_t i = 0; i < 40000; ++i) {
            const double part = films(i).x;
            const Vec3 film(part * diagonal / 2, 0, 0);
            const Vec2 p = (2.0 * rears(i) - Vec2(1)) * reach;
            if (!tracer.from_film({film, Vec3(p.x, p.y, tracer.rear_z()) - film})) continue;
            const Imath::Box2d& pupil = lens.exit_pupils[static_cast<std::size_t>(part * 64)];
            CHECK(pupil.intersects(p));
        }
        const Vec2 middle = lens.exit_pupils.front().size();
        const double radius = std::min(stop, rim), margin = 4 * 3 * std::sqrt(2.0) * rim / 1024;
        CHECK(middle.x < 2.1 * radius + 1.1 * margin);
        CHECK_THAT(middle.x, WithinRel(middle.y, 0.02));
    }
}

TEST_CASE("A lens weighs rays by the light that they carry", "[camera]") {
    // Through a pinhole before the film the weight is the fourth power of the cosine.
    LensSystem lens = focused_lens(0.0005, 2);
    const Vec2 middle = lens.exit_pupils.front().size();
    lens.exposure = 1 / (middle.x * middle.y);
    const LensRays rays(lens, {400, 300});
    CHECK_THAT(rays.ray({200, 150}, Vec2(0.5)).weight, WithinRel(1.0F, 1e-3F));
    const double image = lens.surfaces.back().thickness;
    const double off = 0.016 * 0.8;  // of a film of 32 by 24 mm
    const double cosine2 = image * image / (image * image + off * off);
    const ScrambledSobol points(4);
    double sum = 0;
    constexpr int count = 1 << 14;
    double at_middle = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        sum += rays.ray({360, 150}, points(i)).weight;
        at_middle += rays.ray({200, 150}, points(i)).weight;
    }
    CHECK_THAT(sum / at_middle, WithinRel(cosine2 * cosine2, 0.05));
}
