#include "app/render/summary.h"

#include <fmt/format.h>

#include "app/common/units.h"

namespace etalon {
namespace {

std::string error_reached(const RenderArguments& arguments, const Rendering& rendering,
                          const RenderStats& stats, const Reference* reference) {
    std::string text;
    const bool is_adaptive = arguments.target_error > 0;
    if (is_adaptive || !stats.stopped.empty()) {
        text += fmt::format(", {:.1f} samples a pixel", rendering.samples);
    }
    if (is_adaptive && rendering.expected_error) {
        text += fmt::format(", relMSE {:.2e} expected", *rendering.expected_error);
    } else if (is_adaptive) {
        text += ", relMSE unknown";
    }
    if (reference != nullptr && !reference->history().empty()) {
        const double error = reference->history().back()["relmse"];
        text += fmt::format(", relMSE {:.2e} from {}", error, arguments.reference);
    }
    return text;
}

std::string names_of(const std::vector<std::string>& outputs) {
    std::string names;
    for (const std::string& path : outputs) {
        names += (names.empty() ? "" : ", ") + (path == "-" ? "standard output" : path);
    }
    return names;
}

}  // namespace

std::string summary_of(const RenderArguments& arguments, const Scene& scene,
                       const Rendering& rendering, const RenderStats& stats,
                       const Reference* reference) {
    const std::size_t instances = scene.geometry.instances.size();
    return fmt::format(
        "{}{}: {} primitives{}, {}, {} in {}{} -> {}\n", arguments.scene.path,
        stats.stopped.empty() ? "" : fmt::format(" (stopped: {})", stats.stopped),
        scene.geometry.primitives.size(),
        instances == 0 ? "" : fmt::format(", {} instances", instances), stats.backend,
        rays_text(rendering.counts.total()), seconds_text(stats.render.wall),
        error_reached(arguments, rendering, stats, reference), names_of(arguments.outputs));
}

}  // namespace etalon
