#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/backends.h"
#include "app/commands.h"
#include "app/exit_status.h"
#include "app/output.h"
#include "app/scene_arguments.h"
#include "app/stopwatch.h"
#include "core/intersect/oracle/oracle.h"
#include "core/parallel/parallel.h"
#include "core/render/ray_sets.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    SceneArguments scene;
    std::vector<std::string> backends = backend_names();
    std::size_t rays = 1000;
    std::string json;
};

/// How one backend fared on one kind of ray, against the oracle. Rays that the oracle cannot decide
/// count for nothing but the total.
struct Tally {
    std::size_t rays = 0, undecidable = 0;
    std::size_t class_errors = 0;      ///< hit where there is none, or none where there is one
    std::size_t primitive_errors = 0;  ///< another primitive than the nearest
    std::size_t occlusion_errors = 0;  ///< occluded() where there is no hit, or not where there is
    double t_max_ulp = 0;              ///< in units in the last place of a double
    double seconds = 0;

    bool clean() const { return class_errors + primitive_errors + occlusion_errors == 0; }

    Tally& operator+=(const Tally& o) {
        rays += o.rays;
        undecidable += o.undecidable;
        class_errors += o.class_errors;
        primitive_errors += o.primitive_errors;
        occlusion_errors += o.occlusion_errors;
        t_max_ulp = std::max(t_max_ulp, o.t_max_ulp);
        seconds += o.seconds;
        return *this;
    }
};

std::vector<OracleAnswer> ask_oracle(const Oracle& oracle, const std::vector<Ray>& rays) {
    std::vector<OracleAnswer> answers(rays.size());
    parallel_for(rays.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) answers[i] = oracle.closest(rays[i]);
    });
    return answers;
}

double ulps_between(double a, double b) {
    const double ulp = std::nextafter(std::abs(b), infinity) - std::abs(b);
    return std::abs(a - b) / ulp;
}

bool is_nearest(std::uint32_t primitive, const OracleAnswer& truth) {
    return std::binary_search(truth.tied.begin(), truth.tied.end(), primitive);
}

void compare(const OracleAnswer& truth, const std::optional<Hit>& hit, bool occluded,
             Tally& tally) {
    if (truth.kind == OracleAnswer::undecidable) {
        ++tally.undecidable;
        return;
    }
    const bool is_hit = truth.kind == OracleAnswer::hit;
    if (occluded != is_hit) ++tally.occlusion_errors;
    if (hit.has_value() != is_hit) {
        ++tally.class_errors;
    } else if (is_hit && !is_nearest(hit->primitive, truth)) {
        ++tally.primitive_errors;
    } else if (is_hit) {
        tally.t_max_ulp = std::max(tally.t_max_ulp, ulps_between(hit->t, truth.t));
    }
}

Tally examine(const Intersector& intersector, const RaySet& set,
              const std::vector<OracleAnswer>& truth) {
    Tally tally;
    tally.rays = set.rays.size();
    std::vector<std::optional<Hit>> hits(set.rays.size());
    Stopwatch watch;
    for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = intersector.closest(set.rays[i]);
    tally.seconds = watch.lap().cpu;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        compare(truth[i], hits[i], intersector.occluded(set.rays[i]), tally);
    }
    return tally;
}

Json to_json(const Tally& t) {
    const double rate = t.seconds > 0 ? static_cast<double>(t.rays) / t.seconds * 1e-6 : 0;
    return {{"rays", t.rays},
            {"undecidable", t.undecidable},
            {"class_errors", t.class_errors},
            {"primitive_errors", t.primitive_errors},
            {"t_max_ulp", t.t_max_ulp},
            {"occlusion_errors", t.occlusion_errors},
            {"mrays_per_s", rate}};
}

void print_row(const std::string& backend, const std::string& kind, const Tally& t) {
    fmt::print("{:<15} {:<7} {:>9} rays {:>8} class {:>8} primitive {:>8} occlusion {:>12.3g} ulp",
               backend, kind, t.rays, t.class_errors, t.primitive_errors, t.occlusion_errors,
               t.t_max_ulp);
    fmt::print("{}\n", t.undecidable > 0 ? fmt::format("  ({} undecidable)", t.undecidable) : "");
}

std::vector<RaySet> ray_sets(const Scene& scene, std::size_t limit) {
    const auto exact = find_backend("bvh")->build(scene);
    std::vector<RaySet> sets = make_ray_sets(scene, *exact, limit);
    std::erase_if(sets, [](const RaySet& set) { return set.kind == "random"; });
    return sets;
}

int run(const Arguments& a) {
    const LoadedScene loaded = load(a.scene);
    if (!loaded.scene) return loaded.status;
    const Scene& scene = *loaded.scene;
    const std::vector<RaySet> sets = ray_sets(scene, a.rays);
    const Oracle oracle(scene);
    std::vector<std::vector<OracleAnswer>> truth;
    for (const RaySet& set : sets) truth.push_back(ask_oracle(oracle, set.rays));

    Json result = Json::object();
    bool agreed = true;
    for (const std::string& name : a.backends) {
        const Backend* backend = find_backend(name);
        const auto intersector = backend->build(scene);
        if (!intersector) return exit_unusable;
        Tally total;
        Json kinds = Json::object();
        for (std::size_t i = 0; i < sets.size(); ++i) {
            const Tally tally = examine(*intersector, sets[i], truth[i]);
            print_row(name, sets[i].kind, tally);
            kinds[sets[i].kind] = to_json(tally);
            total += tally;
        }
        result[name] = to_json(total);
        result[name].update(kinds);
        agreed = agreed && (!backend->exact || total.clean());
    }
    if (!a.json.empty() && !write_json(a.json, result)) return exit_not_written;
    return agreed ? exit_done : exit_differs;
}

}  // namespace

Run declare_crosscheck(CLI::App& app) {
    auto a = std::make_shared<Arguments>();
    declare_scene(app, a->scene);
    app.add_option("-b,--backend", a->backends,
                   "Which, by commas; an error of embree-builtin is "
                   "shown but does not count")
        ->delimiter(',')
        ->check(CLI::IsMember(backend_names()))
        ->capture_default_str();
    app.add_option("--rays", a->rays, "Of each kind: camera, bounce, shadow, aimed")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 24))
        ->capture_default_str();
    app.add_option("--json", a->json, "Write the figures to this file; - is standard output");
    return [a] { return run(*a); };
}

}  // namespace etalon
