// Errors of an image against the time that it has taken so far.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon::convergence {

/// The mean of several seeds.
struct Point {
    double samples = 0;      ///< per pixel
    double cpu_seconds = 0;  ///< of rendering, one thread
    double mse = 0, relmse = 0;
    double mse_least = 0, mse_most = 0;  ///< of any seed
    /// Mean of each channel over the reference's, less 1: what no noise explains is bias.
    std::optional<Vec3> mean_difference{};
    std::optional<Vec3> mean_difference_error{};  ///< its standard error, by the seeds

    /// 1 / (relMSE * CPU seconds): as much again is twice the machines. `preparation` is what the
    /// CPU time of the point does not include.
    double efficiency(double preparation = 0) const {
        return 1 / (relmse * (preparation + cpu_seconds));
    }
};

/// The law that points follow.
struct Fit {
    double slope = 0;  ///< of log MSE against log time: -1 for independent samples
    double floor = 0;  ///< MSE that no time takes away: bias, or the noise of the reference
};

/// Convergence of one way to render an image.
struct Curve {
    std::string name;  ///< "whitted, sobol, bvh"
    std::string sampler, integrator, backend;
    std::vector<Point> points{};
    std::optional<Fit> fit{};  ///< nothing where there are too few points for it
    double preparation = 0;    ///< CPU seconds before rendering: starting, reading, building

    /// 1 / (MSE * CPU seconds) of the last point: as much again is twice the machines.
    double efficiency() const;
};

/// Convergence of another program's image; its times are those of whole processes.
struct ForeignCurve {
    std::string program;
    std::vector<Point> points;  ///< by CPU seconds
};

/// The slope is that of the points from 4 samples on. The floor is what the last of them have above
/// c / seconds, the slowest that an image without bias comes closer; 0 if they do not. Nothing for
/// fewer than three points.
std::optional<Fit> fit(const std::vector<Point>& points);

}  // namespace etalon::convergence
