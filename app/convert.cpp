#include <fmt/core.h>

#include <filesystem>
#include <new>
#include <optional>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/output.h"
#include "app/common/signals.h"
#include "app/scene_arguments.h"
#include "app/subcommands.h"
#include "core/base/read_log.h"
#include "core/formats/file_text.h"
#include "core/formats/pbrt/normalize.h"
#include "core/formats/write/write.h"

namespace etalon {
namespace {

struct ConvertArguments {
    SceneArguments scene;
    std::string output, output_format;
};

/// Returns the writer for the output's name; nullptr if its extension is no format that can be
/// written.
SceneWriter writer_of(const ConvertArguments& a) {
    if (a.output != "-") {
        return find_scene_writer(std::filesystem::path(a.output).extension().string());
    }
    return find_scene_writer("." + (a.output_format.empty() ? "p3f" : a.output_format));
}

/// Returns why the output cannot be written, and the exit status; an empty text if it can.
std::pair<std::string, int> check_output(const ConvertArguments& a) {
    if (a.output == "-") return {};
    if (!a.output_format.empty()) {
        return {"--output-format: the output is not -; the names of files tell their formats",
                exit_usage};
    }
    if (!writer_of(a)) {
        return {
            fmt::format("{}: expected a name ending in {}, or -", a.output, writable_extensions()),
            exit_usage};
    }
    return check_outputs({a.output}, {a.scene.path});
}

/// Reports what the format cannot express; returns false if that is an error.
bool tolerates(const ConvertArguments& a, const WrittenScene& written) {
    const bool strict = a.scene.options.strict;
    for (const ConversionWarning& warning : written.lost) {
        print_message("{}: {}: {} cannot express {} ({})\n", a.scene.path,
                      strict ? "error" : "warning", written.format, warning.what, warning.count);
    }
    return written.lost.empty() || !strict;
}

std::filesystem::path output_directory(const ConvertArguments& a) {
    return std::filesystem::path(a.output).parent_path();
}

/// Returns whether a PBRT scene is to be written as PBRT, which then keeps everything that it says.
bool is_pbrt_to_pbrt(const ConvertArguments& a, std::string_view text) {
    return writer_of(a) == write_pbrt && a.scene.legacy.empty() && !text.empty() &&
           format_of(text, a.scene.path, a.scene.options) == "pbrt";
}

/// Writes the scene, unless to one of its files. A signal waits until a file is complete, or else a
/// temporary one would be left. Returns the exit status.
int write(const ConvertArguments& a, const std::vector<std::string>& scene_files,
          const std::string& text) {
    if (refuse_outputs({a.output}, scene_files)) return exit_usage;
    std::optional<SignalGuard> signals;
    if (is_replaceable(a.output)) signals.emplace();
    if (!write_text(a.output, text)) return exit_not_written;
    return SignalGuard::raised() ? exit_signal + SignalGuard::signal() : exit_done;
}

int normalize_pbrt(const ConvertArguments& a, std::string_view text) {
    const ReadLog read(ReadLog::Keeps::paths);
    const pbrt::NormalizedFile file =
        pbrt::normalize(text, a.scene.path, output_directory(a), a.scene.options);
    if (file.text && refuse_frame(a.scene, file.frames)) return exit_usage;
    write_message(report(file.diagnostics));
    if (!file.text) return exit_unusable;
    const std::set<std::string> files = read.paths();
    return write(a, {files.begin(), files.end()}, *file.text);
}

int convert_text(const ConvertArguments& a, std::optional<std::string_view> text) {
    if (text && is_pbrt_to_pbrt(a, *text)) return normalize_pbrt(a, *text);
    const LoadedScene loaded = load(a.scene, text);
    if (!loaded.scene) return loaded.status;
    if (loaded.scene->is_physical()) {
        print_message("{}: error: a scene of {} cannot be converted to P3F; expected one of {}\n",
                      a.scene.path, loaded.scene->format, "P3F, NFF, PRT or SCE");
        return exit_unusable;
    }
    const WrittenScene written = writer_of(a)(*loaded.scene, loaded.settings, output_directory(a));
    if (!tolerates(a, written)) return exit_unusable;
    return write(a, loaded.files, written.text);
}

int convert(const ConvertArguments& a) {
    if (const auto [error, status] = check_output(a); !error.empty()) return fail(status, error);
    limit_memory(a.scene);
    try {
        const FileText file = read_file(a.scene.path);
        return convert_text(a, file.error.empty() ? std::optional(file.text()) : std::nullopt);
    } catch (const std::bad_alloc&) {
        print_message("{}: error: does not fit into memory\n", a.scene.path);
        return exit_unusable;
    }
}

}  // namespace

Action declare_convert(Options& options) {
    auto a = std::make_shared<ConvertArguments>();
    declare_scene(options, a->scene);
    options
        .add("-o,--output", a->output,
             "Output file; its extension, .p3f or .pbrt, gives the format; - is standard output")
        .value("FILE")
        .required();
    options
        .add("--output-format", a->output_format,
             "Format of the scene on standard output, for -o - (default: p3f)")
        .one_of(writable_formats());
    return [a] { return convert(*a); };
}

}  // namespace etalon
