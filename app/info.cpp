#include <fmt/format.h>

#include "app/common/backends.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/scene_arguments.h"
#include "app/stats.h"
#include "app/subcommands.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
    SceneArguments scene;
    bool json = false;
};

bool any_material(const Scene& scene, bool (*test)(const Material&)) {
    return std::any_of(scene.whitted().materials.begin(), scene.whitted().materials.end(), test);
}

/// Returns the features that rendering the scene needs.
std::vector<std::string> needs(const Scene& s, const RenderSettings& settings) {
    std::vector<std::string> list;
    const auto need = [&](bool condition, const char* what) {
        if (condition) list.emplace_back(what);
    };
    const auto is_area = [](const Light& l) { return std::holds_alternative<QuadLight>(l); };
    need(any_material(s, [](const Material& m) { return m.reflection != Color(0.0F); }),
         "mirrored rays");
    need(any_material(s, [](const Material& m) { return m.transmission != Color(0.0F); }),
         "refracted rays");
    need(any_material(s, [](const Material& m) { return m.absorption != Color(0.0F); }),
         "absorption");
    need(std::any_of(s.whitted().lights.begin(), s.whitted().lights.end(), is_area),
         "area light samples");
    need(s.camera.aperture > 0 && settings.samples_per_pixel > 0, "lens samples");
    need(!s.geometry.normals.empty() || s.geometry.all<Polygon>().have_normals(),
         "interpolated normals");
    need(s.whitted().environment.skybox.has_value(), "pictures");
    return list;
}

Json lights(const Scene& scene) {
    Json counts = Json::object();
    for (const Light& light : scene.whitted().lights) {
        const char* kind = std::holds_alternative<QuadLight>(light) ? "quad" : "point";
        counts[kind] = counts.value(kind, 0) + 1;
    }
    return counts;
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

Json describe(const InfoArguments& a, const LoadedScene& loaded) {
    const Scene& s = *loaded.scene;
    const RenderSettings& settings = loaded.settings;
    const Camera& c = s.camera;
    const auto vec = [](const Vec3& v) { return Json{v.x, v.y, v.z}; };
    return {{"scene", a.scene.path},
            {"format", s.format},
            {"primitives", primitive_counts(s)},
            {"vertices", s.geometry.vertices.size() + s.geometry.decimal_vertices.size()},
            {"materials", s.whitted().materials.size()},
            {"lights", lights(s)},
            {"camera",
             {{"eye", vec(c.eye)},
              {"at", vec(c.at)},
              {"up", vec(c.up)},
              {"fov_degrees", c.fov_degrees},
              {"width", settings.resolution.x},
              {"height", settings.resolution.y},
              {"aperture", c.aperture},
              {"focal", c.focal}}},
            {"samples_per_pixel", settings.samples_per_pixel},
            {"integrator", settings.integrator},
            {"max_depth", settings.max_depth},
            {"backend", chosen_backend(settings).name},
            {"background",
             {s.whitted().environment.background.x, s.whitted().environment.background.y,
              s.whitted().environment.background.z}},
            {"skybox",
             s.whitted().environment.skybox ? Json(s.whitted().environment.skybox->faces) : Json()},
            {"needs", needs(s, settings)},
            {"memory_bytes", memory_bytes(s)},
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
        "{}: {}\n  primitives  {}\n  materials   {}\n  lights      {}\n  picture     {} x {}, {} "
        "samples per pixel\n  integrator  {}\n  backend     {}\n  needs       {}\n  memory      {} "
        "bytes\n  "
        "diagnostics {}\n",
        j["scene"].get<std::string>(), j["format"].get<std::string>(), counts_line(j["primitives"]),
        j["materials"].get<std::size_t>(), counts_line(j["lights"]), camera["width"].get<int>(),
        camera["height"].get<int>(), j["samples_per_pixel"].get<int>(),
        j["integrator"].get<std::string>(), j["backend"].get<std::string>(),
        needed.empty() ? "nothing special" : fmt::format("{}", fmt::join(needed, ", ")),
        j["memory_bytes"].get<std::size_t>(), j["diagnostics"].size());
}

int inform(const InfoArguments& a) {
    const LoadedScene loaded = load(a.scene);
    if (!loaded.scene) {
        const Json j{{"scene", a.scene.path}, {"diagnostics", diagnostics(loaded.diagnostics)}};
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
