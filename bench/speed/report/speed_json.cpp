#include "bench/speed/report/speed_json.h"

#include <nlohmann/json.hpp>

#include "app/common/provenance.h"

namespace etalon::speed {
namespace {

using Json = nlohmann::ordered_json;

/// Returns null for an unknown value.
Json json_of(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

/// Writes the timings of builds or rays.
Json json_of(const Runs& runs) {
    return {{"cpu_seconds", median(runs.cpu())},
            {"wall_seconds", median(runs.wall())},
            {"ratio", runs.ratio.median},
            {"spread", json_of(runs.ratio.spread)},
            {"ratio_robust", runs.ratio_robust.median},
            {"spread_robust", json_of(runs.ratio_robust.spread)},
            {"cpu_scaling", runs.cpu_scaling.median},
            {"wall_scaling", runs.wall_scaling.median},
            {"repeats", {{"cpu_seconds", runs.cpu()}, {"wall_seconds", runs.wall()}}}};
}

Json json_of(const BuildFigures& build) {
    Json json = {{"isa", build.isa}, {"bytes_per_primitive", build.bytes_per_primitive}};
    for (const Runs& runs : build.by_threads) {
        json["threads"][std::to_string(runs.threads)] = json_of(runs);
    }
    return json;
}

/// Returns the times and the rates in rays per second that follow from them.
Json json_of(const Runs& runs, double rays) {
    Json json = {{"mrays_per_s", rays / median(runs.cpu()) * 1e-6},
                 {"mrays_per_wall_s", rays / median(runs.wall()) * 1e-6}};
    json.update(json_of(runs));
    return json;
}

Json json_of(const OracleCheck& j) {
    return {{"rays", j.rays},
            {"undecidable", j.undecidable},
            {"false_hits", j.false_hits},
            {"false_misses", j.false_misses},
            {"wrong_primitives", j.wrong_primitives},
            {"wrong_roots", j.wrong_roots},
            {"t_float_ulps_max", j.t_ulps}};
}

Json json_of(const Errors& errors) {
    const Disagreement& d = errors.disagreement;
    return {{"reference", errors.reference},
            {"rays", d.rays},
            {"hit_or_miss", d.hit_or_miss},
            {"primitive", d.primitive},
            {"t_bits", d.distance},
            {"oracle", json_of(errors.sample)},
            {"disputed", json_of(errors.disputed)}};
}

/// Writes the figures for one thread, and under "threads" those for each number of threads.
Json json_of(const RayFigures& figures, double rays) {
    Json json = json_of(figures.by_threads.front(), rays);
    json["errors"] = json_of(figures.errors);
    for (const Runs& runs : figures.by_threads) {
        json["threads"][std::to_string(runs.threads)] = json_of(runs, rays);
    }
    return json;
}

Json json_of(const KindFigures& kind) {
    Json json = Json::object();
    for (const RayFigures& figures : kind.tracers) {
        json[figures.tracer] = json_of(figures, static_cast<double>(kind.rays));
    }
    return json;
}

}  // namespace

Json json_of_environment(const SpeedConfig& config) {
    Json json = provenance();
    json["baselines"] = {baseline, robust_baseline};
    json["repeats"] = config.repeats;
    json["threads"] = config.threads;
    return json;
}

Json json_of(const SceneFigures& scene) {
    Json json = {{"scene", scene.scene}, {"primitives", scene.primitives}, {"shape", scene.shape}};
    for (const BuildFigures& build : scene.builds) json["build"][build.tracer] = json_of(build);
    for (const KindFigures& kind : scene.kinds) json["rays"][kind.kind] = json_of(kind);
    return json;
}

}  // namespace etalon::speed
