#include <numbers>

#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {
namespace {

/// The part of the plane z = 1 that the image shows, before the field of view: the shorter side
/// from -1 to 1 unless the file says otherwise.
Imath::Box2d screen_window(const Parameters& p, const Imath::V2i& resolution) {
    const std::span<const float> given = p.numbers("screenwindow");
    if (given.size() == 4) return {Vec2(given[0], given[2]), Vec2(given[1], given[3])};
    const double own = static_cast<double>(resolution.x) / resolution.y;
    const double aspect = p.is_given("frameaspectratio") ? p.number("frameaspectratio") : own;
    const Vec2 half = aspect > 1 ? Vec2(aspect, 1) : Vec2(1, 1 / aspect);
    return {-half, half};
}

double half_tangent(const Parameters& p) {
    const double half = p.number("halffov") > 0 ? p.number("halffov") : p.number("fov") / 2;
    return std::tan(half * std::numbers::pi / 180);
}

}  // namespace

void build_camera(SceneBuilder& b) {
    const Plugin& plugin = b.frame.camera;
    const Parameters& p = plugin.parameters;
    const std::string_view name = plugin.type->name;
    warn_of_stand_in(b, plugin);
    ProjectiveCamera camera;
    const auto& [start, end] = b.frame.camera_transforms;
    const PlaceInTime place =
        b.place_in_time(affine_part(start.to_world), affine_part(end.to_world));
    camera.to_world = place.at_open;
    camera.motion = place.motion;
    if (name == "environment") {
        camera.projection = Projection::environment;
    } else if (name == "realistic") {
        camera.window = {Vec2(-1), Vec2(1)};
    } else {
        camera.window = screen_window(p, b.result.settings.resolution);
        camera.lens_radius = p.number("lensradius");
        camera.focal_distance = p.number("focaldistance");
        if (name == "orthographic") {
            camera.projection = Projection::orthographic;
        } else {
            camera.window.min *= half_tangent(p);
            camera.window.max *= half_tangent(p);
        }
    }
    Camera& c = b.scene().camera;
    c.eye = camera.to_world.origin;
    c.at = c.eye + camera.to_world.z;
    c.up = camera.to_world.y;
    c.sees_motion = camera.motion.has_value();
    c.projective = camera;
}

}  // namespace etalon::pbrt
