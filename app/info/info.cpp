#include <fmt/format.h>

#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/provenance.h"
#include "app/info/scene_json.h"
#include "app/scene_arguments.h"
#include "app/subcommands.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
    SceneArguments scene;
    bool json = false;
};

std::string counts_line(const Json& counts) {
    std::string line;
    for (const auto& [name, count] : counts.items()) {
        line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count.get<std::uint64_t>(), name);
    }
    return line.empty() ? "none" : line;
}

std::string needs_line(const Json& needs) {
    const auto names = needs.get<std::vector<std::string>>();
    return names.empty() ? "nothing special" : fmt::format("{}", fmt::join(names, ", "));
}

std::string as_text(const Json& j) {
    const auto number = [](const Json& value) { return value.get<std::size_t>(); };
    const auto text = [](const Json& value) { return value.get<std::string>(); };
    const Json& camera = j["camera"];
    const std::pair<const char*, std::string> lines[] = {
        {"frame", fmt::format("{} of {}", number(j["frame"]), number(j["frames"]))},
        {"primitives", counts_line(j["primitives"])},
        {"instances",
         fmt::format("{} of {} objects", number(j["instances"]), number(j["objects"]))},
        {"materials", fmt::format("{}", number(j["materials"]))},
        {"lights", counts_line(j["lights"])},
        {"image", fmt::format("{} x {}, {} samples per pixel", number(camera["width"]),
                              number(camera["height"]), number(j["samples_per_pixel"]))},
        {"integrator",
         text(j["integrator"]) + (j["direct_lighting"].get<bool>() ? ", direct light only" : "")},
        {"backend", text(j["backend"])},
        {"needs", needs_line(j["needs"])},
        {"memory", fmt::format("{} bytes, and {} bytes for images of textures",
                               number(j["memory_bytes"]), number(j["texture_memory_bytes"]))},
        {"diagnostics", fmt::format("{}", j["diagnostics"].size())},
    };
    std::string result = fmt::format("{}: {}\n", text(j["scene"]), text(j["format"]));
    for (const auto& [name, value] : lines) result += fmt::format("  {:<11} {}\n", name, value);
    return result;
}

int inform(const InfoArguments& a) {
    const LoadedScene loaded = load(a.scene);
    if (!loaded.scene) {
        const Json j{{"schema", json_schema},
                     {"scene", a.scene.path},
                     {"diagnostics", diagnostics_json(loaded.diagnostics)}};
        if (a.json && loaded.status == exit_unusable) write_json("-", j);
        return loaded.status;
    }
    const Json j = scene_json(a.scene, loaded);
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
