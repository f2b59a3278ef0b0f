// The camera and the image: the last value counts; the matrix has no effect.
#include <algorithm>
#include <cmath>

#include "core/formats/camera_block.h"
#include "core/formats/sce/sce_loader.h"
#include "core/numerics/rounding.h"

namespace etalon::sce {
namespace {

/// Reads an integer in [least, most], or reports an error.
std::optional<int> read_integer(Reader& in, std::int64_t least, std::int64_t most) {
    const std::size_t offset = in.tokens().offset();
    const std::int64_t n = in.integer("number");
    if (!in.ok()) return std::nullopt;
    if (n >= least && n <= most) return static_cast<int>(n);
    in.warn_at(offset, "range", "'{}' is {}; expected {} to {}", in.keyword(), n, least, most);
    return std::nullopt;
}

}  // namespace

void read_eye(Loader& loader, Reader& in) {
    const Vec3 eye = in.vector("position");
    if (in.ok()) loader.scene.camera.eye = eye;
}

void read_direction(Loader& loader, Reader& in) {
    const Vec3 direction = in.vector("direction");
    if (in.ok()) loader.view = {direction, in.start()};
}

void read_up(Loader& loader, Reader& in) {
    const Vec3 up = in.vector("direction");
    if (!in.ok()) return;
    loader.scene.camera.up = up;
    loader.view.offset = in.start();
}

/// Reads the distance of the view plane, which cancels, since rays start at the eye.
void read_view_distance(Loader&, Reader& in) {
    in.number("distance");
}

void read_field_of_view(Loader& loader, Reader& in) {
    const double angle = in.number("angle");
    if (!in.ok()) return;
    if (!(angle > 0 && angle < 180)) {
        return in.warn("range", "'fovy_deg' is {}; expected more than 0 and less than 180", angle);
    }
    loader.scene.camera.fov_degrees = angle;
}

void read_width(Loader& loader, Reader& in) {
    if (const auto n = read_integer(in, 1, 65536)) loader.settings.resolution.x = *n;
}

void read_height(Loader& loader, Reader& in) {
    if (const auto n = read_integer(in, 1, 65536)) loader.settings.resolution.y = *n;
}

/// Reads the number of reflected rays after the camera ray.
void read_recursion(Loader& loader, Reader& in) {
    if (const auto n = read_integer(in, 0, 999)) loader.settings.max_depth = *n + 1;
}

/// Reads the number of samples along either side of a pixel; 0 is one ray through its centre.
void read_samples(Loader& loader, Reader& in) {
    if (const auto n = read_integer(in, 0, 1024)) loader.settings.samples_per_pixel = *n * *n;
}

void read_background(Loader& loader, Reader& in) {
    const Color color = in.color("colour");
    if (in.ok()) loader.scene.whitted().environment.background = color;
}

/// The point looked at is as far away as the eye is from the origin, up to a factor of two, so that
/// it keeps the digits of the direction, but not nearer than any camera's.
void finalize_camera(Loader& loader) {
    Camera& camera = loader.scene.camera;
    const Vec3 direction = to_unit_magnitude(loader.view.direction);
    const double distance =
        std::max(1 / power_of_two_reciprocal(max_abs(camera.eye)), 2 * least_camera_distance);
    camera.at = camera.eye + distance * direction;
    const Vec3 view = to_unit_magnitude(camera.at - camera.eye);  // has lost digits to the eye's
    const char* const nothing = "so nothing can be rendered";
    if (direction == Vec3(0)) {
        loader.log.error(loader.view.offset, "camera", "'eyedir' is zero, {}", nothing);
    } else if (!(max_abs(camera.at - camera.eye) <= largest_camera_distance)) {
        loader.log.error(loader.view.offset, "camera",
                         "'eyepos' is {} from the origin; expected at most {}, {}",
                         max_abs(camera.eye), largest_camera_distance / 2, nothing);
    } else if (to_unit_magnitude(camera.up).cross(view) == Vec3(0)) {
        loader.log.error(loader.view.offset, "camera", "'eyeup' is along 'eyedir', {}", nothing);
    }
}

}  // namespace etalon::sce
