#include "app/stats.h"

#include <sys/resource.h>

#include "app/common/provenance.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

std::size_t peak_resident_bytes() {
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

Json rays(const RayCounts& r) {
    return {{"camera", r.camera},
            {"camera_hits", r.camera_hits},
            {"shadow", r.shadow},
            {"shadow_blocked", r.shadow_blocked},
            {"reflected", r.reflected},
            {"refracted", r.refracted},
            {"secondary_hits", r.secondary_hits},
            {"total", r.total()}};
}

Json or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

}  // namespace

Json to_json(const RenderStats& s) {
    const double total = s.parse.wall + s.build.wall + s.render.wall + s.aovs.wall + s.write.wall;
    const double rate = s.render.wall > 0 ? static_cast<double>(s.rays.total() - s.resumed_rays) /
                                                s.render.wall * 1e-6
                                          : 0;
    Json json = provenance();
    json.update({{"scene", s.scene},
                 {"format", s.format},
                 {"backend", s.backend},
                 {"integrator", s.integrator},
                 {"direct_lighting", s.direct_lighting},
                 {"threads", s.threads},
                 {"isa", s.isa},
                 {"image",
                  {{"width", s.width},
                   {"height", s.height},
                   {"spp", s.samples_per_pixel},
                   {"seed", s.seed}}},
                 {"primitives", to_json(s.primitives)},
                 {"seconds",
                  {{"parse", s.parse.wall},
                   {"build", s.build.wall},
                   {"render", s.render.wall},
                   {"aovs", s.aovs.wall},
                   {"write", s.write.wall},
                   {"total", total}}},
                 {"cpu_seconds",
                  {{"parse", s.parse.cpu}, {"build", s.build.cpu}, {"render", s.render.cpu}}},
                 {"stopped", s.stopped.empty() ? Json() : Json(s.stopped)},
                 {"checkpoints",
                  {{"written", s.checkpoints},
                   {"seconds", s.checkpoint_seconds},
                   {"resumed_spp", or_null(s.resumed_samples_per_pixel)}}},
                 {"target_error", or_null(s.target_error)},
                 {"expected_error", {{"relmse", or_null(s.expected_error)}}},
                 {"dropped_samples", s.dropped_samples},
                 {"rays", rays(s.rays)},
                 {"mrays_per_s", rate},
                 {"memory_bytes",
                  {{"scene", s.scene_bytes},
                   {"accelerator", s.accelerator_bytes},
                   {"peak_rss", peak_resident_bytes()}}}});
    return json;
}

PrimitiveCounts primitive_counts(const Scene& scene) {
    PrimitiveCounts counts{};
    for (const Primitive p : scene.geometry.primitives) ++counts[p.kind];
    for (const Geometry& object : scene.geometry.objects) {
        for (const Primitive p : object.primitives) ++counts[p.kind];
    }
    return counts;
}

Json to_json(const PrimitiveCounts& counts) {
    Json result = Json::object();
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        if (counts[kind] == 0) continue;
        result[std::string(kind_name(static_cast<ShapeKind>(kind)))] = counts[kind];
    }
    return result;
}

}  // namespace etalon
