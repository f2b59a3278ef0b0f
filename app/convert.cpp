#include <fmt/core.h>

#include <filesystem>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/scene_arguments.h"
#include "app/subcommands.h"
#include "core/formats/write/write.h"

namespace etalon {
namespace {

struct ConvertArguments {
    SceneArguments scene;
    std::string output;
};

int convert(const ConvertArguments& a) {
    const std::filesystem::path path = a.output;
    const SceneWriter write = find_scene_writer(path.extension().string());
    if (!write) {
        print_message("etalon: error: {}: expected a file ending in {}\n", a.output,
                      writable_extensions());
        return exit_usage;
    }
    if (const std::string error = check_writable(a.output); !error.empty()) {
        print_message("etalon: error: {}\n", error);
        return exit_not_written;
    }
    const LoadedScene loaded = load(a.scene);
    if (!loaded.scene) return loaded.status;
    const WrittenScene written = write(*loaded.scene, loaded.settings, path.parent_path());
    for (const ConversionWarning& warning : written.lost) {
        print_message("{}: lost: {} ({})\n", a.output, warning.what, warning.count);
    }
    return write_text(a.output, written.text) ? exit_done : exit_not_written;
}

}  // namespace

Action declare_convert(Options& options) {
    auto a = std::make_shared<ConvertArguments>();
    declare_scene(options, a->scene);
    options
        .add("-o,--output", a->output,
             "Output file; its extension, .p3f or .pbrt, gives the format")
        .value("FILE")
        .required();
    return [a] { return convert(*a); };
}

}  // namespace etalon
