#include "app/replaced_images.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/common/console.h"
#include "app/common/scene_files.h"
#include "app/common/stand_ins.h"
#include "core/image/io.h"
#include "core/image/lack_of_memory.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon {
namespace {

/// A lack of memory is no property of the scene: another run would render another image.
bool is_tolerable(std::string_view problem, const SceneArguments& arguments) {
    return !arguments.options.strict && !problem.ends_with(lack_of_memory);
}

bool is_finite(const Image& image) {
    const auto* const values = std::get_if<std::vector<float>>(&image.pixels);
    return !values ||
           std::ranges::all_of(*values, [](float value) { return std::isfinite(value); });
}

/// Returns the first images of a scene that have values that are infinite or no number. Reads them
/// again, as there are hardly ever any.
std::vector<std::string> images_not_finite(const Scene& scene) {
    constexpr std::size_t most = 5;
    std::vector<std::string> found;
    for (const std::string& file : image_files(scene)) {
        if (found.size() == most) break;
        const Result<Image> image = read_image(file);
        if (image && !is_finite(image.value)) found.push_back(file);
    }
    return found;
}

}  // namespace

bool tolerates(const Scene& scene, const SceneArguments& arguments,
               const std::vector<std::string>& problems) {
    std::vector<ImageProblem> list;
    for (auto problem = problems.begin(); problem != problems.end(); ++problem) {
        if (std::find(problems.begin(), problem, *problem) != problem) continue;
        const bool is_fine = is_tolerable(*problem, arguments);
        list.push_back({is_fine ? Severity::warning : Severity::error, *problem});
    }
    write_message(report(stand_ins(scene, arguments.path, list)));
    return std::ranges::all_of(problems, [&](const auto& p) { return is_tolerable(p, arguments); });
}

void warn_of_dropped_samples(const Scene& scene, const SceneArguments& arguments,
                             std::size_t samples) {
    if (samples == 0) return;
    const std::vector<std::string> causes = images_not_finite(scene);
    print_message("{}: warning: {} samples are infinite or no number: they count as black{}\n",
                  arguments.path, samples,
                  causes.empty()
                      ? ""
                      : fmt::format("; there are such values in {}", fmt::join(causes, ", ")));
}

bool make_cut_outs(Scene& scene, const SceneArguments& arguments) {
    std::vector<std::string> problems;
    make_cut_outs(scene, problems);
    return tolerates(scene, arguments, problems);
}

}  // namespace etalon
