#include "bench/report/command_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/common/program_facts.h"
#include "bench/speed/figures.h"

namespace etalon::bench_report {
namespace {

/// Returns the tracers to request; the baselines are always measured.
std::vector<std::string> requested(const speed::SpeedConfig& config) {
    std::vector<std::string> names = config.tracers;
    std::erase_if(names, [](const std::string& name) {
        return name == speed::baseline || name == speed::robust_baseline;
    });
    return names;
}

}  // namespace

std::string command_of(const Settings& settings) {
    std::string scenes;
    for (const FrameRequest& f : settings.frames) {
        if (f.origin == FrameOrigin::given) scenes += " " + shell_quoted(f.scene);
    }
    const std::string foreign =
        settings.foreign_table.empty() ? "" : " --foreign " + shell_quoted(settings.foreign_table);
    return fmt::format("build/bin/etalon-bench report{}{}{} -o {}",
                       settings.name == "quick" ? " --quick" : "", foreign, scenes,
                       shell_quoted(settings.folder));
}

std::string speed_command(const Settings& settings, const std::string& scene) {
    const speed::SpeedConfig& config = settings.speed_config;
    return fmt::format(
        "build/bin/etalon-bench speed --scene {} --backends {} --threads {} --repeat {} "
        "--max-rays {} --oracle {}",
        scene, fmt::join(requested(config), ","), fmt::join(config.threads, ","), config.repeats,
        config.max_rays, config.oracle_seconds);
}

std::string speed_command(const Settings& settings) {
    return speed_command(settings, fmt::format("{}", fmt::join(settings.speed_scenes, ",")));
}

std::string builds_command(const Settings& settings, const std::string& scene) {
    const speed::SpeedConfig& config = settings.speed_config;
    return fmt::format(
        "build/bin/etalon-bench speed --only-build --scene {} --backends {} --threads {} "
        "--repeat {}",
        scene, fmt::join(requested(config), ","), fmt::join(config.threads, ","), config.repeats);
}

std::string accuracy_command(const Settings& settings) {
    return fmt::format("build/bin/etalon-bench accuracy --backends {} --rays {} --limit {}",
                       fmt::join(settings.accuracy_backends, ","), settings.case_rays,
                       settings.case_seconds);
}

std::string accuracy_command(const Settings& settings, const std::vector<accuracy::Row>& rows,
                             const std::string& shape) {
    std::vector<std::string> ids;
    for (const accuracy::Row& row : rows) {
        const bool is_new = std::find(ids.begin(), ids.end(), row.id) == ids.end();
        if (row.shape == shape && is_new) ids.push_back(row.id);
    }
    return fmt::format("{} --case {}", accuracy_command(settings), fmt::join(ids, ","));
}

std::string spd_command(const Settings& settings) {
    std::string scenes;
    for (const SpdScene& s : settings.spd_scenes) {
        scenes += fmt::format("\"{} {}\" ", s.family, s.size);
    }
    return fmt::format(
        "for scene in {}; do set -- $scene; build/bin/etalon-scenes $1 --size $2 -o $1.p3f; "
        "build/bin/etalon render $1.p3f --spd --stats -; done",
        scenes.substr(0, scenes.size() - 1));
}

std::string frames_command(const Settings& settings, FrameOrigin origin) {
    std::string made, scenes, size;
    for (const FrameRequest& f : settings.frames) {
        if (f.origin != origin) continue;
        const bool is_family = origin == FrameOrigin::family;
        if (is_family) {
            made += fmt::format("build/bin/etalon-scenes {0} --size {1} -o {0}.p3f && ", f.scene,
                                f.size);
        }
        scenes += " " + shell_quoted((origin == FrameOrigin::shipped ? "scenes/" : "") + f.scene +
                                     (is_family ? ".p3f" : ""));
        size = (f.width > 0 ? fmt::format(" --width {}", f.width) : "") +
               (f.samples > 0 ? fmt::format(" --spp {}", f.samples) : "");
    }
    return fmt::format("{}build/bin/etalon-bench frames{}{} --repeat {}", made, scenes, size,
                       settings.frame_repeats);
}

std::string image_command(const ImageRequest& request) {
    const std::string name = std::filesystem::path(request.scene).stem().string();
    const std::string render = fmt::format("build/bin/etalon render scenes/{} --resolution {}x{}",
                                           request.scene, request.width, request.height);
    return fmt::format(
        "{0} --spp {1} -o {2}.exr -o {2}.png --aov cost.boxTests,cost.primitiveTests && {0} --spp "
        "{3} --seed 1 -o fewer.exr && "
        "build/bin/etalon compare fewer.exr {2}.exr --heatmap {2}-error.png",
        render, request.samples, name, request.fewer_samples);
}

std::string convergence_command(const Settings& settings, const ConvergenceRequest& request) {
    return fmt::format(
        "build/bin/etalon-bench convergence scenes/{} --width {} --spp {} --seeds {} --backends {}",
        request.scene, request.width, request.samples, settings.convergence_seeds,
        fmt::join(settings.convergence_backends, ","));
}

std::string foreign_command(const Settings& settings) {
    return fmt::format(
        "build/bin/etalon-bench convergence SCENE --foreign {} --samplers sobol --spp {} --seeds "
        "{}",
        shell_quoted(settings.foreign_table), settings.foreign_samples, settings.foreign_seeds);
}

}  // namespace etalon::bench_report
