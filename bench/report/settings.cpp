#include "bench/report/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "app/common/backends.h"
#include "bench/scenes/bench_scene.h"
#include "bench/speed/pinned.h"
#include "bench/speed/timed_tracer.h"
#include "core/formats/load.h"

namespace etalon::bench_report {
namespace {

/// The reference tests every primitive against every ray, which is too slow for the report.
std::vector<std::string> all_but_reference() {
    std::vector<std::string> names = backend_names();
    std::erase(names, reference_backend);
    return names;
}

struct Cost {
    std::string_view scene;
    double microseconds;
};

constexpr Cost costs[] = {{"showcase.p3f", 7.7},
                          {"features/glass.p3f", 2.7},
                          {"features/soft_shadows.p3f", 0.7},
                          {"features/depth_of_field.p3f", 0.8},
                          {"features/glossy.p3f", 0.9}};

/// Scenes whose whole frames are measured.
constexpr const char* framed[] = {"showcase.p3f", "features/glass.p3f", "features/meshes.p3f",
                                  "features/mirrors.p3f", "features/soft_shadows.p3f"};

/// Width and samples per pixel of a frame; 0: the scene's own.
struct FrameSize {
    int width, samples;
};

/// That of scene files in the quick report, which would have no time for all samples of some.
constexpr FrameSize quick_frame{160, 4};

/// The frames of this project's scenes and of the classic families.
void add_usual_frames(FrameSize shipped, FrameSize family, Settings& s) {
    s.frames.clear();
    for (const char* scene : framed) {
        s.frames.push_back({FrameOrigin::shipped, scene, 0, shipped.width, shipped.samples});
    }
    for (const SpdScene& scene : s.spd_scenes) {
        s.frames.push_back(
            {FrameOrigin::family, scene.family, scene.size, family.width, family.samples});
    }
}

/// Returns whether a file's extension is that of a format that can be read.
bool is_scene(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    const auto names = format_names();
    return !extension.empty() &&
           std::ranges::find(names, std::string_view(extension).substr(1)) != names.end();
}

/// Returns the file, or the scene files in a folder, sorted by name.
std::vector<std::string> files_at(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) return {path};
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
        if (is_scene(entry.path())) files.push_back(entry.path().string());
    }
    std::ranges::sort(files);
    return files;
}

/// Returns whether a scene file is among the frames: it may also be in a folder that was given.
bool is_given(const std::string& file, const Settings& settings) {
    return std::ranges::any_of(settings.frames, [&](const FrameRequest& f) {
        return f.origin == FrameOrigin::given && f.scene == file;
    });
}

/// Makes room for a task of about so many seconds, in case it takes twice as long.
void extend_limit(double seconds, Settings& settings) {
    if (settings.seconds_limit > 0) settings.seconds_limit += 2 * seconds;
}

/// Scenes in which good sampling matters: of lights, lens and highlights.
constexpr const char* converging[] = {"features/soft_shadows.p3f", "features/depth_of_field.p3f",
                                      "features/glossy.p3f"};

}  // namespace

double microseconds_of_sample(const std::string& scene) {
    const auto* cost = std::find_if(std::begin(costs), std::end(costs),
                                    [&](const Cost& c) { return c.scene == scene; });
    return cost != std::end(costs) ? cost->microseconds : 1;
}

Settings quick_settings() {
    Settings s;
    s.name = "quick";
    s.seconds_limit = 160;
    s.speed_scenes = {"terrain:50000", "flake:50000",  "soup:100000",  "stadium:30000",
                      "slivers:10000", "spheres:1000", "spheres:20000"};
    s.speed_config = {speed::with_baselines(all_but_reference()), {1},    3, 0.2,
                      {"camera", "bounce", "shadow", "random"},   1 << 15};
    s.accuracy_backends = all_but_reference();
    s.case_rays = 1024;
    s.case_seconds = 0.1;
    s.spd_scenes = {{"sphereflake", 4}, {"gears", 4}, {"mountain", 6},
                    {"rings", 7},       {"tetra", 6}, {"tree", 11}};
    add_usual_frames(quick_frame, {quick_frame.width, 0}, s);
    s.frame_repeats = 1;
    s.spd_backends = all_but_reference();
    s.images = {{"showcase.p3f", 320, 180, 16, 1},
                {"features/glass.p3f", 320, 213, 16, 1},
                {"features/soft_shadows.p3f", 320, 213, 32, 1},
                {"features/depth_of_field.p3f", 320, 213, 32, 1}};
    for (const char* scene : converging) s.convergence.push_back({scene, 60, 40, 64});
    s.convergence_backends = {default_backend, baseline_backend};
    s.convergence_seeds = 3;
    s.foreign_samples = 16;
    s.foreign_seeds = 2;
    return s;
}

Settings full_settings() {
    Settings s = quick_settings();
    s.name = "full";
    s.seconds_limit = 0;
    s.speed_scenes = {"terrain", "flake", "soup", "stadium", "slivers", "spheres:1000", "spheres"};
    if (speed::usable_cores() > 1) s.speed_config.threads.push_back(speed::usable_cores());
    s.speed_config.repeats = 5;
    s.speed_config.oracle_seconds = 1;
    s.speed_config.max_rays = 1 << 18;
    add_usual_frames({480, 4}, {0, 0}, s);
    s.frame_repeats = 5;
    s.case_rays = 100'000;
    s.case_seconds = 5;
    for (ImageRequest& image : s.images) {
        image.width = image.width * 3 / 2;
        image.height = image.height * 3 / 2;
        image.samples *= 8;
        image.fewer_samples *= 4;
    }
    s.convergence = {{"showcase.p3f", 240, 135, 16}};
    for (const char* scene : converging) s.convergence.push_back({scene, 240, 160, 64});
    s.convergence_seeds = 5;
    s.foreign_samples = 128;
    s.foreign_seeds = 3;
    return s;
}

std::string add_frames(const std::vector<std::string>& paths, Settings& settings) {
    const FrameSize size = settings.name == "quick" ? quick_frame : FrameSize{0, 0};
    for (const std::string& path : paths) {
        const std::vector<std::string> files = files_at(path);
        if (files.empty()) return fmt::format("{}: holds no scene files", path);
        for (const std::string& file : files) {
            const std::string error = bench::check_scene_name(file);
            if (!error.empty()) return error;
            if (is_given(file, settings)) continue;
            settings.frames.push_back({FrameOrigin::given, file, 0, size.width, size.samples});
            extend_limit(seconds_for(settings.frames.back(), settings), settings);
        }
    }
    return {};
}

std::string add_foreign(const std::string& table, Settings& settings) {
    auto images = convergence::read_foreign_table(table);
    if (!images) return images.error;
    settings.foreign_table = table;
    for (const std::string& scene : convergence::scenes_of(images.value)) {
        settings.foreign.push_back({scene, convergence::images_of(images.value, scene)});
        extend_limit(seconds_for(settings.foreign.back(), settings), settings);
    }
    if (settings.foreign.empty()) return table + ": error: no column named scene";
    return {};
}

/// Estimates two renderings, and for each repeat about one and a half more.
double seconds_for(const FrameRequest& request, const Settings& settings) {
    const double renderings = 2 + 1.5 * settings.frame_repeats;
    if (request.samples == 0) return renderings * (request.width > 0 ? 0.1 : 1);
    const double samples = 0.7 * request.width * request.width * request.samples;
    return 1e-6 * renderings * samples * microseconds_of_sample(request.scene);
}

double seconds_for(const ForeignRequest& request, const Settings& settings) {
    constexpr double seconds_of_sample = 4e-6, usual_pixels = 160 * 160;
    const Imath::V2i& size = request.images.front().size;
    const double pixels = size.x > 0 && size.y > 0 ? 1.0 * size.x * size.y : usual_pixels;
    return 0.1 + seconds_of_sample * pixels * settings.foreign_samples * settings.foreign_seeds;
}

}  // namespace etalon::bench_report
