#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/provenance.h"
#include "app/common/scene_files.h"
#include "app/common/stand_ins.h"
#include "app/info/scene_json.h"
#include "app/scene_arguments.h"
#include "app/subcommands.h"
#include "core/image/io.h"

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

/// Returns the number of diagnostics, those that were left out included.
std::size_t diagnostics_in(const Json& list) {
    std::size_t count = list.size();
    for (const Json& diagnostic : list) count += diagnostic.value("more", std::size_t{0});
    return count;
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
        {"diagnostics", fmt::format("{}", diagnostics_in(j["diagnostics"]))},
    };
    std::string result = fmt::format("{}: {}\n", text(j["scene"]), text(j["format"]));
    for (const auto& [name, value] : lines) result += fmt::format("  {:<11} {}\n", name, value);
    return result;
}

/// Adds what rendering would say of images that cannot be read, and prints it. Drops the scene if
/// that is an error.
void add_stand_ins(const SceneArguments& a, LoadedScene& loaded) {
    const Severity severity = a.options.strict ? Severity::error : Severity::warning;
    std::vector<ImageProblem> problems;
    for (const std::string& file : image_files(*loaded.scene)) {
        std::string reason = read_image(file, Extent::header).error;
        if (!reason.empty()) problems.push_back({severity, std::move(reason)});
    }
    std::vector<Diagnostic> found = stand_ins(*loaded.scene, a.path, problems);
    write_message(report(found));
    if (a.options.strict && !found.empty()) {
        loaded.scene.reset();
        loaded.status = exit_unusable;
    }
    std::ranges::move(found, std::back_inserter(loaded.diagnostics));
}

int inform(const InfoArguments& a) {
    LoadedScene loaded = load(a.scene);
    if (loaded.scene) add_stand_ins(a.scene, loaded);
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
