#include "app/info/scene_json.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/common/backends.h"
#include "app/common/provenance.h"
#include "app/info/look_facts.h"
#include "app/stats.h"
#include "core/texture/texture_memory.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the full vertical field of view, in degrees.
double field_of_view(const ProjectiveCamera& c, const ImageWindow& window) {
    constexpr double degree = std::numbers::pi / 180;
    if (c.projection == Projection::environment) return 180;
    if (c.projection == Projection::orthographic) return 0;
    return std::abs(std::atan(window.top) - std::atan(window.bottom)) / degree;
}

std::string_view name_of(Projection projection) {
    switch (projection) {
        case Projection::orthographic:
            return "orthographic";
        case Projection::environment:
            return "environment";
        case Projection::lens_system:
            return "realistic";
        default:
            return "perspective";
    }
}

/// Returns the numbers of a camera that has no space of its own.
Camera described(const Camera& c, const Imath::V2i& resolution) {
    if (!c.projective) return c;
    Camera result = c;
    const ImageWindow window = c.projective->window(resolution);
    const double pixel_height = std::abs(window.height()) / resolution.y;
    result.fov_degrees = field_of_view(*c.projective, window);
    result.aperture =
        c.projective->lens_radius > 0 ? 2 * c.projective->lens_radius / pixel_height : 0;
    result.focal = c.projective->focal_distance;
    return result;
}

Json camera_json(const Camera& camera, const Imath::V2i& resolution) {
    const Camera c = described(camera, resolution);
    const auto vec = [](const Vec3& v) { return Json{v.x, v.y, v.z}; };
    return {
        {"eye", vec(c.eye)},
        {"at", vec(c.at)},
        {"up", vec(c.up)},
        {"projection", name_of(c.projective ? c.projective->projection : Projection::perspective)},
        {"fov_degrees", c.fov_degrees},
        {"width", resolution.x},
        {"height", resolution.y},
        {"aperture", c.aperture},
        {"focal", c.focal}};
}

/// Returns the number of vertices of triangles, including those of objects.
std::size_t vertices(const Geometry& geometry) {
    std::size_t count = geometry.vertices.size() + geometry.decimal_vertices.size();
    for (const Geometry& object : geometry.objects) count += vertices(object);
    return count;
}

std::size_t texture_bytes(const Scene& scene) {
    return scene.is_physical() ? texture_memory_bytes(scene.physical().textures) : 0;
}

}  // namespace

Json diagnostics_json(const std::vector<Diagnostic>& list) {
    Json result = Json::array();
    for (const Diagnostic& d : list) {
        result.push_back({{"severity", d.severity == Severity::error ? "error" : "warning"},
                          {"file", d.file},
                          {"line", d.line},
                          {"column", d.column},
                          {"message", d.message}});
        if (d.more > 0) result.back()["more"] = d.more;
    }
    return result;
}

Json scene_json(const SceneArguments& a, const LoadedScene& loaded) {
    const Scene& s = *loaded.scene;
    const RenderSettings& settings = loaded.settings;
    const LookFacts look = facts_of(s, settings);
    return {{"schema", json_schema},
            {"scene", a.path},
            {"format", s.format},
            {"frame", std::max(a.options.frame, 1)},
            {"frames", loaded.frames},
            {"primitives", to_json(primitive_counts(s))},
            {"objects", s.geometry.objects.size()},
            {"instances", s.geometry.instances.size()},
            {"vertices", vertices(s.geometry)},
            {"materials", look.materials},
            {"lights", look.lights},
            {"camera", camera_json(s.camera, settings.resolution)},
            {"samples_per_pixel", settings.samples_per_pixel},
            {"integrator", settings.integrator},
            {"direct_lighting", settings.direct_lighting},
            {"max_depth", settings.max_depth},
            {"backend", chosen_backend(settings).name},
            {"background", look.background},
            {"skybox", look.skybox},
            {"needs", look.needs},
            {"memory_bytes", memory_bytes(s)},
            {"texture_memory_bytes", texture_bytes(s)},
            {"diagnostics", diagnostics_json(loaded.diagnostics)}};
}

}  // namespace etalon
