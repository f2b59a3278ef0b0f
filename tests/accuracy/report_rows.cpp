#include "tests/accuracy/report_rows.h"

#include <cmath>

namespace etalon::accuracy {

Row row(std::string id, std::string shape, std::string tracer, double ulps, std::uint64_t errors,
        double cost) {
    Row r;
    r.id = std::move(id);
    r.variant = "1e3 <radii> & more";
    r.shape = std::move(shape);
    r.criterion = "oracle";
    r.tracer = std::move(tracer);
    r.exact = errors == 0;
    r.stats.rays = 1000000;
    r.stats.false_hits = errors;
    for (const double share : {0.0, 0.3, 1.0}) {
        r.stats.float_ulps.add(share * ulps);
        r.stats.double_ulps.add(share * std::ldexp(ulps, 29));
        r.stats.conditioned.add(share * 3.1e10);
        r.stats.position.add(share * 5.123e-10);
        r.stats.shift.add(share * 2.5e-12);
    }
    r.cost = cost;
    r.nanoseconds = 10.0 / 3 * (cost > 0 ? cost : 1);
    return r;
}

std::vector<Row> sample_rows() {
    std::vector<Row> rows;
    for (const char* id : {"SPH-1", "SPH-2"}) {
        rows.push_back(row(id, "sphere", "bvh", 1e-9, 0, 9.3));
        rows.push_back(row(id, "sphere", "embree", 1e-9, 0, 12.5));
        rows.push_back(row(id, "sphere", "embree-builtin", 83, 999999, 11));
        rows.push_back(row(id, "sphere", "kernel", 1e-9, 0, 1.6));
        rows.push_back(row(id, "sphere", "float textbook", 4590, 46227, 1));
        rows.push_back(row(id, "sphere", "double textbook", 1e-6, 20, 1.1));
    }
    for (const char* tracer : {"bvh", "embree-builtin"}) {
        for (const char* judge : {"enclosed", "spawned"}) {
            Row r = row(judge, "scene", tracer, 0, 0, 0);
            r.exact = r.tracer == "bvh";
            r.criterion = judge;
            r.stats.leaks = r.criterion == "enclosed" && !r.exact ? 240000 : 0;
            rows.push_back(r);
        }
    }
    return rows;
}

}  // namespace etalon::accuracy
