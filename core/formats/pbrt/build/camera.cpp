#include <numbers>

#include "core/camera/exit_pupil.h"
#include "core/camera/lens_focus.h"
#include "core/formats/pbrt/build/lens_file.h"
#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {
namespace {

/// Returns the part of the plane z = 1 that the image shows if the file fixes it, by its borders or
/// by its aspect ratio.
std::optional<ImageWindow> fixed_window(const Parameters& p, double half_side) {
    const std::span<const float> given = p.numbers("screenwindow");
    if (given.size() == 4) {
        return ImageWindow{given[0] * half_side, given[1] * half_side, given[2] * half_side,
                           given[3] * half_side};
    }
    if (!p.is_given("frameaspectratio")) return std::nullopt;
    return centred_window(half_side, p.number("frameaspectratio"));
}

/// Returns whether a window has an area that rays can be distributed over.
bool has_area(const ImageWindow& window) {
    const double area = window.width() * window.height();
    return area != 0 && std::isfinite(area);
}

double half_tangent(const Parameters& p) {
    const double half = p.number("halffov") > 0 ? p.number("halffov") : p.number("fov") / 2;
    return std::tan(half * std::numbers::pi / 180);
}

/// Sets the diameter of a lens's stops, unless it is larger than the file's.
void stop_down(SceneBuilder& b, const Plugin& plugin, std::vector<LensSurface>& surfaces) {
    const float diameter = plugin.parameters.number("aperturediameter");
    for (LensSurface& s : surfaces) {
        if (s.curvature_radius != 0) continue;
        // As floats, in which a diameter that both files give is the same.
        if (const auto most = static_cast<float>(2e3 * s.aperture_radius); diameter > most) {
            b.warn(plugin.where, "lens", "aperturediameter {}: taken as {}, the lens file's",
                   diameter, most);
        } else {
            s.aperture_radius = std::max(0.0, diameter / 2e3);
        }
    }
}

/// Returns the part of the plane z = 1 that a film at that distance behind its lens shows.
ImageWindow window_of(double diagonal, double image_distance, const Imath::V2i& resolution) {
    const Vec2 size(resolution);
    const Vec2 half = size / size.length() * (diagonal / 2 / image_distance);
    return {-half.x, half.x, -half.y, half.y};
}

/// Returns the focused lens of a realistic camera, or why there is none.
Result<LensSystem> lens_system(SceneBuilder& b, const Plugin& plugin, LensFocus& focus) {
    const Parameters& p = plugin.parameters;
    if (p.string("lensfile").empty()) return {{}, "no lensfile is given"};
    auto surfaces = read_lens_file(std::string(p.string("lensfile")), b.strict, b.log);
    if (!surfaces) return {{}, surfaces.error};
    stop_down(b, plugin, surfaces.value);
    LensSystem lens{
        std::move(surfaces.value), b.frame.film.parameters.number("diagonal") / 1e3, {}, 1};
    if (!(lens.film_diagonal > 0)) return {{}, "the film's diagonal is not positive"};
    const Result<LensFocus> found = focused(lens, p.number("focusdistance"));
    if (!found) return {{}, "its lens cannot be focused: " + found.error};
    focus = found.value;
    lens.surfaces.back().thickness = focus.film_distance;
    lens.exit_pupils = exit_pupils(lens.surfaces, lens.film_diagonal);
    const Vec2 middle = lens.exit_pupils.front().size();
    const double shutter = std::abs(p.number("shutterclose") - p.number("shutteropen"));
    lens.exposure = p.flag("simpleweighting")
                        ? 1 / (middle.x * middle.y)
                        : shutter / (focus.film_distance * focus.film_distance);
    return {std::move(lens), {}};
}

void add_lens(SceneBuilder& b, const Plugin& plugin, ProjectiveCamera& camera) {
    LensFocus focus{};
    Result<LensSystem> lens = lens_system(b, plugin, focus);
    if (!lens) {
        b.warn(plugin.where, "lens", "{}; a perspective camera stands in for the realistic one",
               lens.error);
        return;
    }
    camera.projection = Projection::lens_system;
    camera.fixed_window =
        window_of(lens.value.film_diagonal, focus.image_distance, b.result.settings.resolution);
    camera.focal_distance = plugin.parameters.number("focusdistance");
    camera.lens = std::move(lens.value);
}

/// Sets the window and the thin lens of a perspective or an orthographic camera.
void add_window(SceneBuilder& b, const Plugin& plugin, ProjectiveCamera& camera) {
    const Parameters& p = plugin.parameters;
    if (plugin.type->name == "orthographic") {
        camera.projection = Projection::orthographic;
    } else {
        camera.half_side = half_tangent(p);
    }
    camera.fixed_window = fixed_window(p, camera.half_side);
    camera.lens_radius = p.number("lensradius");
    camera.focal_distance = p.number("focaldistance");
    if (has_area(camera.window(b.result.settings.resolution))) return;
    b.warn(plugin.where, "window", "the image shows no area; a window from -1 to 1 stands in");
    camera.fixed_window.reset();
    camera.half_side = 1;
}

}  // namespace

void build_camera(SceneBuilder& b) {
    const Plugin& plugin = b.frame.camera;
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
        add_lens(b, plugin, camera);
    } else {
        add_window(b, plugin, camera);
    }
    Camera& c = b.scene().camera;
    c.eye = camera.to_world.origin;
    c.at = c.eye + camera.to_world.z;
    c.up = camera.to_world.y;
    c.sees_motion = camera.motion.has_value();
    c.projective = camera;
}

}  // namespace etalon::pbrt
