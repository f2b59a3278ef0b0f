#include "bench/convergence/curve_report.h"

#include <fmt/format.h>

namespace etalon::convergence {

nlohmann::ordered_json json_of(const Curve& curve) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const Point& p : curve.points) {
        points.push_back({{"spp", p.samples},
                          {"cpu_seconds", p.cpu_seconds},
                          {"mse", p.mse},
                          {"mse_least", p.mse_least},
                          {"mse_most", p.mse_most},
                          {"relmse", p.relmse}});
    }
    return {{"name", curve.name},       {"sampler", curve.sampler},
            {"backend", curve.backend}, {"integrator", curve.integrator},
            {"slope", curve.fit.slope}, {"floor", curve.fit.floor},
            {"points", points},         {"efficiency", curve.efficiency()}};
}

std::string table(const Curve& curve) {
    std::string text = fmt::format("{}\n{:>10} {:>10} {:>11} {:>11}  seeds' MSE\n", curve.name,
                                   "spp", "CPU s", "relMSE", "MSE");
    for (const Point& p : curve.points) {
        text += fmt::format("{:10.2f} {:10.4f} {:11.3e} {:11.3e}  {:.3e} to {:.3e}\n", p.samples,
                            p.cpu_seconds, p.relmse, p.mse, p.mse_least, p.mse_most);
    }
    return text + fmt::format("  MSE falls as time^{:.2f}, floor {:.1e}; 1/(MSE s) {:.3e}\n",
                              curve.fit.slope, curve.fit.floor, curve.efficiency());
}

}  // namespace etalon::convergence
