#include "app/render/image_files.h"

#include <algorithm>
#include <filesystem>

#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/render/fail_with.h"
#include "core/image/atomic_file.h"
#include "core/image/io.h"

namespace etalon {

std::string default_output(const std::string& scene) {
    const std::string stem = scene == "-" ? "render" : std::filesystem::path(scene).stem().string();
    return stem + ".exr";
}

int check_image_files(const RenderArguments& a, const std::vector<std::string>& scene_files) {
    std::vector<std::string> paths = a.outputs, inputs = scene_files;
    inputs.insert(inputs.end(), {a.scene.path, a.reference});
    paths.push_back(a.stats);
    auto [error, status] = check_outputs(paths, inputs);
    paths.push_back(a.checkpoint);
    if (error.empty()) {
        error = find_clash(paths, inputs);
        status = exit_usage;
    }
    const bool uses_standard_output = std::ranges::count(paths, "-") > 0;
    if (error.empty() && a.serve && uses_standard_output) {
        error = "standard output has the address of the page; expected files";
        status = exit_usage;
    }
    if (error.empty() && std::ranges::count(a.outputs, "-") > 0) {
        error = check_image_to_standard_output();
        status = exit_usage;
    }
    return error.empty() ? exit_done : (fail_with(error), status);
}

bool write_image_file(const RenderArguments& a, const std::string& path, const RenderedImage& image,
                      const KeptState& kept) {
    const std::string name = path == "-" ? "standard output" : path;
    auto file = encode_image(format_name(a, path), image, a.exposure);
    if (!file) return fail_with(name + ": cannot be written: " + file.error);
    if (can_hold_channels(format_name(a, path))) kept.append_film(image, file.value);
    if (path == "-") return write_result(file.value);  // a failure is reported at the end
    const std::string error = write_file_atomically(path, file.value);
    return error.empty() || fail_with(error);
}

}  // namespace etalon
