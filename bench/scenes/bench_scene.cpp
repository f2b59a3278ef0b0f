#include "bench/scenes/bench_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/common/program_facts.h"
#include "app/common/scene_files.h"
#include "app/common/stand_ins.h"
#include "bench/scenes/bench_families.h"
#include "core/base/parse_number.h"
#include "core/formats/load.h"
#include "core/scene/resize.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon::bench {
namespace {

/// The parts of "FAMILY" or "FAMILY:SIZE".
struct Request {
    explicit Request(const std::string& name) {
        const std::size_t colon = name.find(':');
        const std::string_view word = std::string_view(name).substr(0, colon);
        const auto found = std::find_if(families().begin(), families().end(),
                                        [&](const Family& f) { return f.name == word; });
        if (found == families().end()) return;
        family = &*found;
        if (colon == std::string::npos) {
            size = family->usual;
        } else {
            size = parse_number<std::size_t>(name.substr(colon + 1)).value_or(0);
        }
    }

    bool has_size() const { return size >= 1 && size <= family->most; }

    const Family* family = nullptr;
    std::size_t size = 0;  ///< 0 if it is not a number
};

std::string names_of_families() {
    std::string names;
    for (const Family& f : families()) names += fmt::format("{}[:{}], ", f.name, f.unit);
    return names;
}

NamedScene from_file(const std::string& path) {
    const ReadLog read(ReadLog::Keeps::paths);
    LoadResult loaded = load_scene(path);
    std::string messages = report(loaded.diagnostics);
    std::vector<std::string> files;
    if (loaded.scene) {
        files = scene_files(read, *loaded.scene);
        std::vector<std::string> problems;
        make_cut_outs(*loaded.scene, problems);
        messages += stand_in_warnings(*loaded.scene, path, problems);
    }
    return {std::move(loaded.scene), std::move(loaded.settings), std::move(messages),
            std::move(files)};
}

}  // namespace

std::string check_scene_name(const std::string& name) {
    const Request request(name);
    if (request.family != nullptr) {
        if (request.has_size()) return "";
        return fmt::format("{}: expected {} from 1 to {} after {}:", name, request.family->unit,
                           request.family->most, request.family->name);
    }
    std::error_code ignored;
    if (name == "-" || std::filesystem::exists(name, ignored)) return "";
    return fmt::format("{}: no such scene: expected {}or a scene file", name, names_of_families());
}

NamedScene bench_scene(const std::string& name) {
    const std::string error = check_scene_name(name);
    if (!error.empty()) {
        return {std::nullopt, {}, fmt::format("{}: error: {}\n", program_name(), error)};
    }
    const Request request(name);
    if (request.family == nullptr) return from_file(name);
    RenderSettings settings;
    settings.resolution = Imath::V2i(request.family->pixels);
    return {request.family->make(request.size), settings, ""};
}

void set_width(RenderSettings& settings, int width) {
    if (width == 0) return;
    const Imath::V2i& size = settings.resolution;
    const std::int64_t height = (std::int64_t{size.y} * width + size.x / 2) / size.x;
    resize(settings,
           {width, static_cast<int>(std::clamp<std::int64_t>(height, 1, max_image_side))});
}

std::string list_of_scenes() {
    std::string text;
    for (const Family& f : families()) {
        text += fmt::format("{:<20} {}\n", fmt::format("{}:{}", f.name, f.usual), f.what);
    }
    return text;
}

}  // namespace etalon::bench
