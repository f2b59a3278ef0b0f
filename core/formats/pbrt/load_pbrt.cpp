#include "core/formats/pbrt/load_pbrt.h"

#include <algorithm>

#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon {
namespace {

using namespace pbrt;

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
    return std::ranges::any_of(diagnostics,
                               [](const Diagnostic& d) { return d.severity == Severity::error; });
}

/// Returns a diagnostic about the file as a whole.
Diagnostic about_file(const ParsedFile& file, Severity severity, std::string message) {
    return {severity, "file", file.files.front(), 0, 0, std::move(message)};
}

}  // namespace

LoadResult load_pbrt(std::string_view text, const std::string& path, const LoadOptions& options) {
    ParsedFile file = parse(text, path, {options.strict, options.root, options.one_sided});
    LoadResult result;
    const bool usable =
        !file.frames.empty() && !file.is_fatal && !(options.strict && has_errors(file.diagnostics));
    if (!usable) {
        if (!has_errors(file.diagnostics)) {
            file.diagnostics.push_back(
                about_file(file, Severity::error, "no WorldEnd: expected a frame to render"));
        }
        result.diagnostics = std::move(file.diagnostics);
        return result;
    }
    result.frames = static_cast<int>(file.frames.size());
    if (options.frame == 0 && result.frames > 1) {
        file.diagnostics.push_back(about_file(
            file, options.strict ? Severity::error : Severity::warning,
            fmt::format(
                "{} frames in one file, of which this is the first; --frame N chooses another",
                result.frames)));
    }
    result.scene.emplace();
    result.scene->look = PhysicalLook{};
    const int number = std::clamp(options.frame, 1, result.frames);
    SceneBuilder b{file, file.frames[static_cast<std::size_t>(number - 1)], options.strict, result,
                   options.integrator};
    build_settings(b);
    build_camera(b);
    build_textures(b);
    build_materials(b);
    build_media(b);
    build_lights(b);
    build_shapes(b);
    result.diagnostics = std::move(file.diagnostics);
    std::ranges::move(b.log.take(), std::back_inserter(result.diagnostics));
    if (options.strict && has_errors(result.diagnostics)) result.scene.reset();
    return result;
}

}  // namespace etalon
