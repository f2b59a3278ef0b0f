#include "bench/accuracy/report/accuracy_json.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/common/provenance.h"

namespace etalon::accuracy {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Distribution& d) {
    return {{"count", d.count()},
            {"p50", d.quantile(0.5)},
            {"p99", d.quantile(0.99)},
            {"max", d.max()}};
}

Json json_of(const Row& row) {
    const ErrorStats& t = row.stats;
    return {{"id", row.id},
            {"variant", row.variant},
            {"shape", row.shape},
            {"judge", row.criterion},
            {"tracer", row.tracer},
            {"exact", row.exact},
            {"partial", row.partial},
            {"rays", t.rays},
            {"undecidable", t.undecidable},
            {"errors", t.errors()},
            {"false_hits", t.false_hits},
            {"false_misses", t.false_misses},
            {"wrong_roots", t.wrong_roots},
            {"wrong_primitives", t.wrong_primitives},
            {"leaks", t.leaks},
            {"self_hits", t.self_hits},
            {"contradictions", t.contradictions},
            {"deviations", t.deviations},
            {"t_float_ulps", json_of(t.float_ulps)},
            {"t_double_ulps", json_of(t.double_ulps)},
            {"conditioned", json_of(t.conditioned)},
            {"position", json_of(t.position)},
            {"shift", json_of(t.shift)},
            {"nanoseconds", row.nanoseconds},
            {"cost", row.cost}};
}

/// Returns the processor's name as Linux reports it, or "unknown".
std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

}  // namespace

RunEnvironment run_environment() {
    const BuildFacts& build = build_facts();
    return {processor(), std::string(build.compiler), std::string(build.flags),
            std::string(build.version)};
}

nlohmann::ordered_json json(const std::vector<Row>& rows) {
    Json list = Json::array();
    for (const Row& row : rows) list.push_back(json_of(row));
    Json json = provenance();
    json["machine"] = processor();
    json["rows"] = std::move(list);
    return json;
}

}  // namespace etalon::accuracy
