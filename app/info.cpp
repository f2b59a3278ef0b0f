#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/common/backends.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/provenance.h"
#include "app/scene_arguments.h"
#include "app/stats.h"
#include "app/subcommands.h"
#include "core/texture/texture_memory.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
    SceneArguments scene;
    bool json = false;
};

/// What there is to say of a scene's look.
struct LookFacts {
    std::size_t materials = 0;
    Json lights = Json::object();  ///< their number by kind
    Json background{}, skybox{};   ///< null where the look has none
    std::vector<std::string> needs{};

    void count_light(std::string_view kind) {
        Json& count = lights[std::string(kind)];
        count = count.is_null() ? 1 : count.get<int>() + 1;
    }
    void need(bool condition, const char* what) {
        if (condition) needs.emplace_back(what);
    }
};

LookFacts facts_of(const WhittedLook& look) {
    LookFacts facts{look.materials.size()};
    for (const Light& light : look.lights) {
        facts.count_light(std::holds_alternative<QuadLight>(light) ? "quad" : "point");
    }
    const Color& background = look.environment.background;
    facts.background = {background.x, background.y, background.z};
    if (look.environment.skybox) facts.skybox = look.environment.skybox->faces;
    const auto any = [&](bool (*test)(const Material&)) {
        return std::ranges::any_of(look.materials, test);
    };
    facts.need(any([](const Material& m) { return m.reflection != Color(0.0F); }), "mirrored rays");
    facts.need(any([](const Material& m) { return m.transmission != Color(0.0F); }),
               "refracted rays");
    facts.need(any([](const Material& m) { return m.absorption != Color(0.0F); }), "absorption");
    facts.need(facts.lights.contains("quad"), "area light samples");
    facts.need(look.environment.skybox.has_value(), "pictures");
    return facts;
}

LookFacts facts_of(const PhysicalLook& look) {
    LookFacts facts{look.materials.size()};
    constexpr std::string_view kinds[] = {"point",   "spot",     "goniometric", "projection",
                                          "distant", "infinite", "area"};
    for (const PhysicalLight& light : look.lights) facts.count_light(kinds[light.index()]);
    facts.need(facts.lights.contains("area"), "area light samples");
    facts.need(!look.textures.numbers.empty() || !look.textures.colors.empty(), "textures");
    facts.need(!look.textures.images.empty(), "pictures");
    facts.need(!look.media.empty(), "media");
    return facts;
}

LookFacts facts_of(const Scene& s, const RenderSettings& settings) {
    LookFacts facts = std::visit([](const auto& look) { return facts_of(look); }, s.look);
    const bool has_lens = s.camera.projective
                              ? s.camera.projective->lens_radius > 0 || s.camera.projective->lens
                              : s.camera.aperture > 0;
    facts.need(has_lens && settings.samples_per_pixel > 0, "lens samples");
    facts.need(s.camera.sees_motion && settings.samples_per_pixel > 0, "time samples");
    facts.need(!s.geometry.normals.empty() || s.geometry.all<Polygon>().have_normals(),
               "interpolated normals");
    return facts;
}

/// "more" counts further diagnostics of the same kind, which were left out.
Json diagnostics(const std::vector<Diagnostic>& list) {
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

/// Full vertical field of view, in degrees.
double field_of_view(const ProjectiveCamera& c) {
    constexpr double degree = std::numbers::pi / 180;
    if (c.projection == Projection::environment) return 180;
    if (c.projection == Projection::orthographic) return 0;
    return (std::atan(c.window.max.y) - std::atan(c.window.min.y)) / degree;
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

/// The camera as its numbers are for one without a space of its own.
Camera described(const Camera& c, const Imath::V2i& resolution) {
    if (!c.projective) return c;
    Camera result = c;
    const double pixel_height = c.projective->window.size().y / resolution.y;
    result.fov_degrees = field_of_view(*c.projective);
    result.aperture =
        c.projective->lens_radius > 0 ? 2 * c.projective->lens_radius / pixel_height : 0;
    result.focal = c.projective->focal_distance;
    return result;
}

/// Number of vertices of triangles, those of objects included.
std::size_t vertices(const Geometry& geometry) {
    std::size_t count = geometry.vertices.size() + geometry.decimal_vertices.size();
    for (const Geometry& object : geometry.objects) count += vertices(object);
    return count;
}

std::size_t texture_bytes(const Scene& scene) {
    return scene.is_physical() ? texture_memory_bytes(scene.physical().textures) : 0;
}

std::string instances_line(const Json& j) {
    return fmt::format("{} of {} objects", j["instances"].get<std::size_t>(),
                       j["objects"].get<std::size_t>());
}

Json describe(const InfoArguments& a, const LoadedScene& loaded) {
    const Scene& s = *loaded.scene;
    const RenderSettings& settings = loaded.settings;
    const Camera c = described(s.camera, settings.resolution);
    const LookFacts look = facts_of(s, settings);
    const auto vec = [](const Vec3& v) { return Json{v.x, v.y, v.z}; };
    return {{"schema", json_schema},
            {"scene", a.scene.path},
            {"format", s.format},
            {"frame", std::max(a.scene.options.frame, 1)},
            {"frames", loaded.frames},
            {"primitives", to_json(primitive_counts(s))},
            {"objects", s.geometry.objects.size()},
            {"instances", s.geometry.instances.size()},
            {"vertices", vertices(s.geometry)},
            {"materials", look.materials},
            {"lights", look.lights},
            {"camera",
             {{"eye", vec(c.eye)},
              {"at", vec(c.at)},
              {"up", vec(c.up)},
              {"projection",
               name_of(c.projective ? c.projective->projection : Projection::perspective)},
              {"fov_degrees", c.fov_degrees},
              {"width", settings.resolution.x},
              {"height", settings.resolution.y},
              {"aperture", c.aperture},
              {"focal", c.focal}}},
            {"samples_per_pixel", settings.samples_per_pixel},
            {"integrator", settings.integrator},
            {"max_depth", settings.max_depth},
            {"backend", chosen_backend(settings).name},
            {"background", look.background},
            {"skybox", look.skybox},
            {"needs", look.needs},
            {"memory_bytes", memory_bytes(s)},
            {"texture_memory_bytes", texture_bytes(s)},
            {"diagnostics", diagnostics(loaded.diagnostics)}};
}

std::string counts_line(const Json& counts) {
    std::string line;
    for (const auto& [name, count] : counts.items()) {
        line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count.get<std::uint64_t>(), name);
    }
    return line.empty() ? "none" : line;
}

std::string as_text(const Json& j) {
    const Json& camera = j["camera"];
    const auto needed = j["needs"].get<std::vector<std::string>>();
    return fmt::format(
        "{}: {}\n  frame       {} of {}\n  primitives  {}\n  instances   {}\n  materials   {}\n  "
        "lights      {}\n  picture "
        "    {} x {}, {} "
        "samples per pixel\n  integrator  {}\n  backend     {}\n  needs       {}\n  memory      {} "
        "bytes, and {} bytes of images of textures\n  "
        "diagnostics {}\n",
        j["scene"].get<std::string>(), j["format"].get<std::string>(), j["frame"].get<int>(),
        j["frames"].get<int>(), counts_line(j["primitives"]), instances_line(j),
        j["materials"].get<std::size_t>(), counts_line(j["lights"]), camera["width"].get<int>(),
        camera["height"].get<int>(), j["samples_per_pixel"].get<int>(),
        j["integrator"].get<std::string>(), j["backend"].get<std::string>(),
        needed.empty() ? "nothing special" : fmt::format("{}", fmt::join(needed, ", ")),
        j["memory_bytes"].get<std::size_t>(), j["texture_memory_bytes"].get<std::size_t>(),
        j["diagnostics"].size());
}

int inform(const InfoArguments& a) {
    const LoadedScene loaded = load(a.scene);
    if (!loaded.scene) {
        const Json j{{"schema", json_schema},
                     {"scene", a.scene.path},
                     {"diagnostics", diagnostics(loaded.diagnostics)}};
        if (a.json && loaded.status == exit_unusable) write_json("-", j);
        return loaded.status;
    }
    const Json j = describe(a, loaded);
    const bool written = a.json ? write_json("-", j) : write_text("-", as_text(j));
    return written ? exit_done : exit_not_written;
}

}  // namespace

Action declare_info(Options& options) {
    auto a = std::make_shared<InfoArguments>();
    declare_scene(options, a->scene);
    options.add_flag("--json", a->json, "Write JSON instead of text");
    return [a] { return inform(*a); };
}

}  // namespace etalon
