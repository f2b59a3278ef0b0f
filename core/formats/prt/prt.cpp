#include "core/formats/prt/prt.h"

#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "core/formats/prt/loader.h"
#include "core/formats/statements.h"

namespace etalon {
namespace {

using prt::Loader;
using Entry = Keyword<Loader>;

/// What objects before any `surface` are made of: the program crashed.
Material matt_grey() {
    Material m;
    m.diffuse = Color(0.5F);
    return m;
}

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
    CameraLine{"resolution", read_resolution},
};

/// The document has the camera first, then lights, then objects; the program takes any order.
void warn_of_order(Loader& loader, bool is_camera) {
    const bool after_objects = !loader.scene.primitives.empty() || !loader.definitions.empty();
    if (after_objects || (is_camera && !loader.scene.lights.empty())) {
        loader.in.warn("order", "'{}' after {}; PRT's document has it before them",
                       loader.in.keyword(), after_objects ? "objects" : "lights");
    }
}

template <std::size_t line>
void read_camera_line(Loader& loader) {
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

void read_light(Loader& loader) {
    warn_of_order(loader, false);
    const Vec3 position = loader.in.vector("position");
    if (loader.in.ok()) loader.add_light(position);
}

/// The colour may be followed by a letter, whose meaning the program never gave it.
void read_sky(Loader& loader) {
    read_background(loader);
    const std::string_view word = loader.in.tokens().peek();
    const bool letter = word.size() == 1 && !loader.in.tokens().at_number();
    if (loader.in.ok() && letter) loader.in.tokens().next();
}

constexpr std::array objects = {
    Entry{"polygon", [](Loader& l) { read_polygon(l); }},
    Entry{"sphere", [](Loader& l) { read_sphere(l); }},
    Entry{"cone", [](Loader& l) { read_cone(l); }},
    Entry{"surface", prt::read_surface},
    Entry{"hsphere", prt::read_hollow_sphere},
    Entry{"ring", prt::read_ring},
    Entry{"quadric", prt::read_quadric},
};

constexpr std::array others = {
    Entry{"instance_of", prt::read_instance_of},
    Entry{"instance", prt::read_instance},
    Entry{"end_instance", prt::read_end_instance},
    Entry{"light", read_light},
    Entry{"background", read_sky},
    Entry{camera_lines[0].name, read_camera_line<0>},
    Entry{camera_lines[1].name, read_camera_line<1>},
    Entry{camera_lines[2].name, read_camera_line<2>},
    Entry{camera_lines[3].name, read_camera_line<3>},
    Entry{camera_lines[4].name, read_camera_line<4>},
};

constexpr auto keywords = [] {
    std::array<Entry, objects.size() + others.size()> all{};
    std::ranges::copy(others, std::ranges::copy(objects, all.begin()).out);
    return all;
}();

constexpr auto names = names_of(keywords);

std::string missing_lines(const Loader& loader) {
    std::vector<std::string_view> missing;
    for (std::size_t k = 0; k < camera_lines.size(); ++k) {
        if (!loader.camera_lines[k]) missing.push_back(camera_lines[k].name);
    }
    return fmt::format("{}", fmt::join(missing, ", "));
}

/// The program took half the picture's extent for tan(angle) / sqrt(2).
double legacy_fov(double degrees) {
    const double half = std::tan(degrees * (std::numbers::pi / 180)) / std::numbers::sqrt2;
    return 2 * std::atan(half) * (180 / std::numbers::pi);
}

/// What the program did to a picture. It read the centre of a quadric and forgot it.
void apply_legacy(Loader& loader) {
    Camera& camera = loader.camera.camera;
    camera.fov_degrees = legacy_fov(camera.fov_degrees);
    camera.pixel_rays = PixelRays::upper_left;
    loader.scene.whitted.fit_eye_rays = true;
    for (Quadric& q : loader.scene.all<Quadric>()) q.centre = Vec3(0);
}

}  // namespace

namespace prt {

std::span<const std::string_view> object_names() {
    return std::span(names).first(objects.size());
}

void read_objects(Loader& loader) {
    read_statements(loader, objects);
}

}  // namespace prt

LoadResult load_prt(std::string_view text, const std::string& path, const LoadOptions& options) {
    DiagnosticLog log(path, text, options.strict);
    Loader loader{
        {Reader(text, log, names), options, std::filesystem::path(path).parent_path(), matt_grey()},
        text};
    loader.scene.format = "prt";
    loader.scene.display_colors = true;
    read_statements(loader, keywords);
    if (loader.open) prt::drop_open_definition(loader);
    loader.camera.camera.stretched = true;
    if (options.legacy) apply_legacy(loader);
    if (loader.has_camera_lines) settle_camera(loader, loader.camera, missing_lines(loader));
    return loader.finish(log);
}

}  // namespace etalon
