#include <nlohmann/json.hpp>

#include "app/crosscheck/crosscheck_report.h"

namespace etalon::crosscheck {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const CrosscheckCounts& t) {
    const double rate = t.seconds > 0 ? static_cast<double>(t.rays) / t.seconds * 1e-6 : 0;
    return {{"rays", t.rays},
            {"undecidable", t.undecidable},
            {"class_errors", t.class_errors},
            {"primitive_errors", t.primitive_errors},
            {"t_errors", t.t_errors},
            {"t_p50_ulp", t.t_quantile(0.5)},
            {"t_p99_ulp", t.t_quantile(0.99)},
            {"t_max_ulp", t.t_quantile(1)},
            {"occlusion_errors", t.occlusion_errors},
            {"differences", t.differences},
            {"mrays_per_s", rate}};
}

Json to_json(const Contingency& c) {
    return {{"a", c.a},
            {"b", c.b},
            {"both_right", c.both_right},
            {"only_a_right", c.only_a_right},
            {"only_b_right", c.only_b_right},
            {"both_wrong", c.both_wrong},
            {"mcnemar", c.mcnemar()}};
}

}  // namespace

Json as_json(const Results& results) {
    Json json = Json::object();
    for (const BackendResults& b : results.backends) {
        json[b.name] = to_json(b.total);
        for (std::size_t k = 0; k < results.kinds.size(); ++k) {
            json[b.name][results.kinds[k]] = to_json(b.by_kind[k]);
        }
    }
    json["contingency"] = Json::array();
    for (const Contingency& c : results.contingencies) json["contingency"].push_back(to_json(c));
    json["stopped"] = results.stopped ? Json("signal") : Json();
    return json;
}

}  // namespace etalon::crosscheck
