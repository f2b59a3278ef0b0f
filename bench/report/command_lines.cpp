#include "bench/report/command_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/common/program_facts.h"
#include "bench/report/measure/rendered.h"
#include "bench/speed/figures.h"

namespace etalon::bench_report {
namespace {

/// Return how these programs are called.
std::string bench_program() {
    return sibling_program("etalon-bench");
}
std::string etalon_program() {
    return sibling_program("etalon");
}
std::string scenes_program() {
    return sibling_program("etalon-scenes");
}

std::string quoted_path(const std::string& shipped_scene) {
    return shell_quoted(shipped_path(shipped_scene));
}

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
    return fmt::format("{} report{}{}{} -o {}", bench_program(),
                       settings.name == "quick" ? " --quick" : "", foreign, scenes,
                       shell_quoted(settings.folder));
}

std::string speed_command(const Settings& settings, const std::string& scene) {
    const speed::SpeedConfig& config = settings.speed_config;
    return fmt::format(
        "{} speed --scene {} --backends {} --threads {} --repeat {} --max-rays {} --oracle {}",
        bench_program(), scene, fmt::join(requested(config), ","), fmt::join(config.threads, ","),
        config.repeats, config.max_rays, config.oracle_seconds);
}

std::string speed_command(const Settings& settings) {
    return speed_command(settings, fmt::format("{}", fmt::join(settings.speed_scenes, ",")));
}

std::string builds_command(const Settings& settings, const std::string& scene) {
    const speed::SpeedConfig& config = settings.speed_config;
    return fmt::format("{} speed --only-build --scene {} --backends {} --threads {} --repeat {}",
                       bench_program(), scene, fmt::join(requested(config), ","),
                       fmt::join(config.threads, ","), config.repeats);
}

std::string accuracy_command(const Settings& settings) {
    return fmt::format("{} accuracy --backends {} --rays {} --limit {}", bench_program(),
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
        "for scene in {}; do set -- $scene; {} $1 --size $2 -o $1.p3f; "
        "for backend in {}; do {} render $1.p3f --spd -b $backend --stats -; done; done",
        scenes.substr(0, scenes.size() - 1), scenes_program(),
        fmt::join(settings.spd_backends, " "), etalon_program());
}

std::string frames_command(const Settings& settings, FrameOrigin origin) {
    std::string made, scenes, size;
    for (const FrameRequest& f : settings.frames) {
        if (f.origin != origin) continue;
        const bool is_family = origin == FrameOrigin::family;
        if (is_family) {
            made +=
                fmt::format("{0} {1} --size {2} -o {1}.p3f && ", scenes_program(), f.scene, f.size);
        }
        scenes += " " + (origin == FrameOrigin::shipped
                             ? quoted_path(f.scene)
                             : shell_quoted(f.scene + (is_family ? ".p3f" : "")));
        size = (f.width > 0 ? fmt::format(" --width {}", f.width) : "") +
               (f.samples > 0 ? fmt::format(" --spp {}", f.samples) : "");
    }
    return fmt::format("{}{} frames{}{} --repeat {}", made, bench_program(), scenes, size,
                       settings.frame_repeats);
}

std::string image_command(const ImageRequest& request) {
    const std::string name = std::filesystem::path(request.scene).stem().string();
    const std::string render =
        fmt::format("{} render {} --resolution {}x{}", etalon_program(), quoted_path(request.scene),
                    request.width, request.height);
    return fmt::format(
        "{0} --spp {1} -o {2}.exr -o {2}.png --aov cost.boxTests,cost.primitiveTests && {0} --spp "
        "{3} --seed 1 -o fewer.exr && "
        "{4} compare fewer.exr {2}.exr --heatmap {2}-error.png",
        render, request.samples, name, request.fewer_samples, etalon_program());
}

std::string convergence_command(const Settings& settings, const ConvergenceRequest& request) {
    return fmt::format("{} convergence {} --width {} --spp {} --seeds {} --backends {}",
                       bench_program(), quoted_path(request.scene), request.width, request.samples,
                       settings.convergence_seeds, fmt::join(settings.convergence_backends, ","));
}

std::string foreign_command(const Settings& settings) {
    return fmt::format("{} convergence SCENE --foreign {} --samplers sobol --spp {} --seeds {}",
                       bench_program(), shell_quoted(settings.foreign_table),
                       settings.foreign_samples, settings.foreign_seeds);
}

}  // namespace etalon::bench_report
