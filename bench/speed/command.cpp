// etalon-bench speed: how many rays a second, and how many bytes and seconds of building, each
// backend needs, beside how often it disagrees with the exact kernels on the same rays.
#include <fmt/format.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/backends.h"
#include "app/exit_status.h"
#include "app/output.h"
#include "app/stopwatch.h"
#include "bench/commands.h"
#include "bench/scenes/bench_scene.h"
#include "core/parallel/parallel.h"
#include "core/render/ray_sets.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_rays = 1 << 20;  ///< of each kind

struct Arguments {
    std::vector<std::string> scenes{"soup:1000000", "spheres:100000"};
    std::vector<std::string> backends = backend_names();
    std::vector<std::string> rays{"camera", "bounce", "shadow", "random"};
    int repeats = 5;
    bool only_build = false, list = false;
    std::string json;
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Contender {
    const Backend* backend;
    std::unique_ptr<Intersector> intersector;
    double build_seconds;
};

/// What a backend answers to one ray, kept for comparison; occlusion queries know no primitive.
struct Answer {
    std::uint32_t primitive = no_index;
    bool operator==(const Answer&) const = default;
};

Answer ask(const Intersector& intersector, const RaySet& set, const Ray& ray) {
    if (set.occlusion) return {intersector.occluded(ray) ? 0 : no_index};
    const std::optional<Hit> hit = intersector.closest(ray);
    return {hit ? hit->primitive : no_index};
}

/// CPU seconds of all rays of a set, one thread.
double time_rays(const Intersector& intersector, const RaySet& set, std::vector<Answer>& answers) {
    Stopwatch watch;
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        answers[i] = ask(intersector, set, set.rays[i]);
    }
    return watch.lap().cpu;
}

/// Rays per second by alternating repeats, forwards and backwards in turn, so that a drift of the
/// machine's speed meets all alike.
std::vector<double> measure(const std::vector<Contender>& contenders, const RaySet& set,
                            int repeats, std::vector<std::vector<Answer>>& answers) {
    std::vector<std::vector<double>> seconds(contenders.size());
    answers.assign(contenders.size(), std::vector<Answer>(set.rays.size()));
    for (int r = 0; r < repeats; ++r) {
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            const std::size_t k = r % 2 == 0 ? i : contenders.size() - 1 - i;
            seconds[k].push_back(time_rays(*contenders[k].intersector, set, answers[k]));
        }
    }
    std::vector<double> rates;
    for (const auto& s : seconds) rates.push_back(static_cast<double>(set.rays.size()) / median(s));
    return rates;
}

std::vector<Contender> build_all(const Arguments& a, const Scene& scene) {
    std::vector<Contender> contenders;
    for (const std::string& name : a.backends) {
        const Backend* backend = find_backend(name);
        Stopwatch watch;
        auto intersector = backend->build(scene);
        if (intersector) contenders.push_back({backend, std::move(intersector), watch.lap().cpu});
    }
    return contenders;
}

/// The rate the others are compared with: embree-builtin's where it takes part.
double yardstick(const std::vector<Contender>& contenders, const std::vector<double>& rates) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        if (contenders[i].backend->name == "embree-builtin") return rates[i];
    }
    return rates.front();
}

Json measure_set(const Arguments& a, const std::vector<Contender>& contenders, const RaySet& set,
                 const Intersector& exact) {
    std::vector<std::vector<Answer>> answers;
    const std::vector<double> rates = measure(contenders, set, a.repeats, answers);
    const double unit = yardstick(contenders, rates);
    Json result = Json::object();
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        std::size_t differing = 0;
        for (std::size_t k = 0; k < set.rays.size(); ++k) {
            if (answers[i][k] != ask(exact, set, set.rays[k])) ++differing;
        }
        const double per_million =
            1e6 * static_cast<double>(differing) / static_cast<double>(set.rays.size());
        result[std::string(contenders[i].backend->name)] = {{"mrays_per_s", rates[i] * 1e-6},
                                                            {"ratio", rates[i] / unit},
                                                            {"differing_per_million", per_million}};
        fmt::print("  {:<8} {:<15} {:9.3f} Mrays/s  {:6.3f}  {:9.1f} differing per million\n",
                   set.kind, contenders[i].backend->name, rates[i] * 1e-6, rates[i] / unit,
                   per_million);
    }
    return result;
}

Json measure_scene(const Arguments& a, const std::string& name, const Scene& scene) {
    fmt::print("{}: {} primitives\n", name, scene.primitives.size());
    const std::vector<Contender> contenders = build_all(a, scene);
    Json result = {{"scene", name}, {"primitives", scene.primitives.size()}};
    for (const Contender& c : contenders) {
        const auto bytes = static_cast<double>(c.intersector->memory_bytes());
        const double per_primitive = bytes / static_cast<double>(scene.primitives.size());
        result["build"][std::string(c.backend->name)] = {{"cpu_seconds", c.build_seconds},
                                                         {"bytes_per_primitive", per_primitive}};
        fmt::print("  build    {:<15} {:9.3f} s CPU  {:8.1f} bytes per primitive\n",
                   c.backend->name, c.build_seconds, per_primitive);
    }
    if (a.only_build) return result;
    const auto exact = find_backend("bvh")->build(scene);
    for (const RaySet& set : make_ray_sets(scene, *exact, max_rays)) {
        const bool wanted = std::find(a.rays.begin(), a.rays.end(), set.kind) != a.rays.end();
        if (wanted && !set.rays.empty() && !contenders.empty()) {
            result["rays"][set.kind] = measure_set(a, contenders, set, *exact);
        }
    }
    return result;
}

/// Before anything is measured: a slip of the pen in the last name is to cost no hour.
bool are_all_there(const std::vector<std::string>& scenes) {
    std::string complaints;
    for (const std::string& name : scenes) {
        const std::string complaint = bench::complaint_about(name);
        if (!complaint.empty()) complaints += "etalon-bench: error: " + complaint + "\n";
    }
    fmt::print(stderr, "{}", complaints);
    return complaints.empty();
}

int run(const Arguments& a) {
    if (a.list) {
        fmt::print("{}", bench::list_of_scenes());
        return exit_done;
    }
    if (!are_all_there(a.scenes)) return exit_unusable;
    const ThreadLimit one_thread(1);
    Json results = Json::array();
    for (const std::string& name : a.scenes) {
        const bench::NamedScene named = bench::bench_scene(name);
        fmt::print(stderr, "{}", named.messages);
        if (!named.scene) return exit_unusable;
        results.push_back(measure_scene(a, name, *named.scene));
    }
    const Json all = {{"version", ETALON_VERSION}, {"repeats", a.repeats}, {"scenes", results}};
    if (!a.json.empty() && !write_json(a.json, all)) return exit_not_written;
    return exit_done;
}

}  // namespace

Run declare_speed(CLI::App& app) {
    auto a = std::make_shared<Arguments>();
    app.add_option("--scene", a->scenes,
                   "Names as --list has them, with or without :SIZE, or files; several by commas")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--backends", a->backends, "Which, by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(backend_names()))
        ->capture_default_str();
    app.add_option("--rays", a->rays, "Kinds of rays, by commas")
        ->delimiter(',')
        ->check(CLI::IsMember({"camera", "bounce", "shadow", "aimed", "random"}))
        ->capture_default_str();
    app.add_flag("--list", a->list, "Only say which scenes there are by name");
    app.add_flag("--only-build", a->only_build, "Shoot no rays");
    app.add_option("--repeat", a->repeats, "Alternating repeats; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--json", a->json, "Write the figures to this file; - is standard output");
    return [a] { return run(*a); };
}

}  // namespace etalon
