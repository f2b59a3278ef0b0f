// from, at, up, angle, resolution, light and background.
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "core/formats/prt/prt_loader.h"

namespace etalon::prt {
namespace {

struct CameraLine {
    std::string_view name;
    void (*read)(Reader&, CameraBlock&);
};

constexpr std::array camera_lines = {
    CameraLine{"from", [](Reader& in, CameraBlock& b) { b.camera.eye = in.vector("eye"); }},
    CameraLine{"at", [](Reader& in, CameraBlock& b) { b.camera.at = in.vector("point"); }},
    CameraLine{"up", [](Reader& in, CameraBlock& b) { b.camera.up = in.vector("direction"); }},
    CameraLine{"angle",
               [](Reader& in, CameraBlock& b) { b.camera.fov_degrees = in.number("degrees"); }},
    CameraLine{"resolution", etalon::read_resolution},
};

/// The document has the camera first, then lights, then objects; the program takes any order.
void warn_of_order(Loader& loader, bool is_camera) {
    const bool after_objects =
        !loader.scene.geometry.primitives.empty() || !loader.definitions.empty();
    if (after_objects || (is_camera && !loader.scene.whitted().lights.empty())) {
        loader.in.warn("order", "'{}' after {}; PRT's document has it before them",
                       loader.in.keyword(), after_objects ? "objects" : "lights");
    }
}

void read_line(Loader& loader, std::size_t line) {
    Reader& in = loader.in;
    warn_of_order(loader, true);
    if (!loader.has_camera_lines) loader.camera.start = in.start();
    loader.has_camera_lines = true;
    const CameraBlock before = loader.camera;
    camera_lines[line].read(in, loader.camera);
    if (!in.ok()) {
        loader.camera = before;
        return;
    }
    if (loader.camera_lines[line]) {
        in.warn("camera", "a second '{}'; it replaces the first", in.keyword());
    }
    loader.camera_lines[line] = true;
}

std::string missing_lines(const Loader& loader) {
    std::vector<std::string_view> missing;
    for (std::size_t k = 0; k < camera_lines.size(); ++k) {
        if (!loader.camera_lines[k]) missing.push_back(camera_lines[k].name);
    }
    return fmt::format("{}", fmt::join(missing, ", "));
}

/// The program used half the image's extent as tan(angle) / sqrt(2). It is negative beyond 90
/// degrees, which turns the image upside down.
void set_legacy_angle(Camera& camera) {
    const double half =
        std::tan(camera.fov_degrees * (std::numbers::pi / 180)) / std::numbers::sqrt2;
    camera.fov_degrees = 2 * std::atan(std::abs(half)) * (180 / std::numbers::pi);
    if (half < 0) camera.up = -camera.up;
}

void set_quadric_centres(Geometry& geometry, const Vec3& centre) {
    for (Quadric& q : geometry.all<Quadric>()) q.centre = centre;
}

/// Moves quadrics to where PRT's program had them: about the world's origin, as it ignored their
/// centre. An instance moved only their box, so that each needs its own object.
void ignore_quadric_centres(Geometry& geometry) {
    set_quadric_centres(geometry, Vec3(0));
    std::vector<bool> taken(geometry.objects.size());
    for (Instance& instance : geometry.instances) {
        if (geometry.objects[instance.object].all<Quadric>().empty()) continue;
        if (taken[instance.object]) {
            geometry.objects.push_back(Geometry(geometry.objects[instance.object]));
            instance.object = static_cast<std::uint32_t>(geometry.objects.size() - 1);
        } else {
            taken[instance.object] = true;
        }
        set_quadric_centres(geometry.objects[instance.object], -instance.origin);
    }
}

/// Rounds exponents as the program did, which had no highlight where that gives 0.
void round_exponents(std::vector<Material>& materials) {
    for (Material& m : materials) {
        m.shininess = std::round(m.shininess);
        if (m.shininess == 0) m.specular = Color(0.0F);
    }
}

/// Applies the rules of PRT's program.
void apply_legacy(Scene& scene, RenderSettings& settings) {
    set_legacy_angle(scene.camera);
    settings.pixel_rays = PixelRays::upper_left;
    settings.whitted.normalize_camera_rays = true;
    ignore_quadric_centres(scene.geometry);
    round_exponents(scene.whitted().materials);
}

}  // namespace

void read_from(Loader& loader) {
    read_line(loader, 0);
}

void read_at(Loader& loader) {
    read_line(loader, 1);
}

void read_up(Loader& loader) {
    read_line(loader, 2);
}

void read_angle(Loader& loader) {
    read_line(loader, 3);
}

void read_resolution(Loader& loader) {
    read_line(loader, 4);
}

void read_light(Loader& loader) {
    warn_of_order(loader, false);
    const Vec3 position = loader.in.vector("position");
    if (loader.in.ok()) loader.add_light(position);
}

/// The colour may be followed by a letter, which the program ignored.
void read_background(Loader& loader) {
    etalon::read_background(loader);
    const std::string_view word = loader.in.tokens().peek();
    const bool letter = word.size() == 1 && !loader.in.tokens().at_number();
    if (loader.in.ok() && letter) loader.in.tokens().next();
}

void finalize_view(Loader& loader) {
    loader.camera.camera.stretched = true;
    if (loader.has_camera_lines) finalize_camera(loader, loader.camera, missing_lines(loader));
    if (loader.options.legacy) apply_legacy(loader.scene, loader.settings);
}

}  // namespace etalon::prt
