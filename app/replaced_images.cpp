#include "app/replaced_images.h"

#include <algorithm>

#include "app/common/console.h"
#include "app/common/stand_ins.h"
#include "core/image/lack_of_memory.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon {
namespace {

/// A lack of memory is no property of the scene: another run would render another image.
bool is_tolerable(std::string_view problem, const SceneArguments& arguments) {
    return !arguments.options.strict && !problem.ends_with(lack_of_memory);
}

}  // namespace

bool tolerates(const Scene& scene, const SceneArguments& arguments,
               const std::vector<std::string>& problems) {
    for (auto problem = problems.begin(); problem != problems.end(); ++problem) {
        if (std::find(problems.begin(), problem, *problem) != problem) continue;
        const bool is_fine = is_tolerable(*problem, arguments);
        list.push_back({is_fine ? Severity::warning : Severity::error, *problem});
    }
    return std::ranges::all_of(problems, [&](const auto& p) { return is_tolerable(p, arguments); });
}

bool make_cut_outs(Scene& scene, const SceneArguments& arguments) {
    std::vector<std::string> problems;
    make_cut_outs(scene, problems);
    return tolerates(scene, arguments, problems);
}

}  // namespace etalon
    std::vector<ImageProblem> list;
    write_message(report(stand_ins(scene, arguments.path, list)));
