#include "app/scene_arguments.h"

#include <fmt/core.h>

#include <filesystem>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/memory_limit.h"
#include "app/common/output.h"
#include "app/common/scene_files.h"

namespace etalon {
namespace {

std::vector<std::string> strings(std::span<const std::string_view> names) {
    return {names.begin(), names.end()};
}

/// Adds a warning that nothing is visible, as in a truncated file; an error if warnings are.
void note_no_shapes(LoadResult& result, const SceneArguments& a) {
    if (!result.scene || result.scene->geometry.item_count() > 0) return;
    const bool strict = a.options.strict;
    result.diagnostics.push_back({strict ? Severity::error : Severity::warning, "empty", a.path, 0,
                                  0, "no shapes: the image shows the background only"});
    if (strict) result.scene.reset();
}

}  // namespace

void declare_scene(Options& options, SceneArguments& a) {
    options.add("SCENE", a.path, "Scene file; - is standard input").required();
    const char* group = "Scene";
    options
        .add("--format", a.options.format,
             "Format of the scene (default: detected by content, then extension)")
        .one_of(strings(format_names()))
        .group(group);
    options.add_flag("--strict", a.options.strict, "Treat warnings about the scene as errors")
        .group(group);
    options
        .add("--legacy", a.legacy,
             "Reproduce the shading of the original program of this format (default: off)")
        .one_of(strings(legacy_names()))
        .group(group);
    options
        .add("--frame", a.options.frame,
             "Frame of a PBRT file with several, each of which ends with WorldEnd (default: the "
             "first; convert: all)")
        .within(1, most_frames)
        .group(group);
    options
        .add("--root", a.options.root,
             "Let the scene open no file outside of this directory, wherever symbolic links lead "
             "(default: any file)")
        .value("DIR")
        .check([](const std::string& directory) {
            std::error_code none;
            if (std::filesystem::is_directory(directory, none)) return std::string();
            return directory + ": expected a directory";
        })
        .group(group);
    options
        .add("--max-memory", a.max_memory,
             "Memory for the scene, its accelerator and its image, as 500M, 4G or 1.5GiB; beyond "
             "it the program ends, with a message (default: three quarters of the machine's)")
        .value("SIZE")
        .check([](const std::string& size) {
            if (parse_bytes(size)) return std::string();
            return size + ": expected a size as 500M, 4G or 1.5GiB";
        })
        .group(group);
    options
        .add_flag("--one-sided", a.options.one_sided, "Show opaque surfaces from their front only")
        .group(group);
}

bool refuse_frame(const SceneArguments& a, int frames) {
    if (a.options.frame <= frames) return false;
    const std::string held =
        frames == 1 ? "one frame" : fmt::format("{0} frames; expected 1 to {0}", frames);
    fail(exit_usage, fmt::format("--frame {}: {} holds {}", a.options.frame, a.path, held));
    return true;
}

bool refuse_outputs(const std::vector<std::string>& outputs,
                    const std::vector<std::string>& scene_files) {
    const std::string error = find_clash(outputs, scene_files);
    if (error.empty()) return false;
    fail(exit_usage, error);
    return true;
}

void limit_memory(const SceneArguments& a) {
    limit_memory(parse_bytes(a.max_memory).value_or(0));
}

LoadedScene load(SceneArguments a, std::optional<std::string_view> text) {
    limit_memory(a);
    a.options.legacy = !a.legacy.empty();
    const ReadLog read(ReadLog::Keeps::paths);
    LoadResult result =
        text ? load_scene_text(*text, a.path, a.options) : load_scene(a.path, a.options);
    if (result.scene && refuse_frame(a, result.frames)) return {std::nullopt, {}, exit_usage, {}};
    note_no_shapes(result, a);
    write_message(report(result.diagnostics));
    if (!result.scene) return {std::nullopt, {}, exit_unusable, std::move(result.diagnostics)};
    if (!a.legacy.empty() && a.legacy != result.scene->format) {
        const std::string error =
            fmt::format("--legacy {}: expected a scene of {}, found one of {}", a.legacy, a.legacy,
                        result.scene->format);
        return {std::nullopt, {}, fail(exit_usage, error), {}};
    }
    std::vector<std::string> files = scene_files(read, *result.scene);
    return {std::move(result.scene),
            std::move(result.settings),
            exit_done,
            std::move(result.diagnostics),
            result.frames,
            std::move(files)};
}

}  // namespace etalon
