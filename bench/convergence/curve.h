// Errors of an image over rendering time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon::convergence {

/// A point of a curve: the mean of several seeds.
struct Point {
    double samples = 0;      ///< per pixel
    double cpu_seconds = 0;  ///< of rendering on one thread
    double mse = 0, relmse = 0;
    double mse_least = 0, mse_most = 0;  ///< range over the seeds
    /// Mean of each channel over the reference's, minus 1: what noise does not explain is bias.
    std::optional<Vec3> mean_difference{};
    std::optional<Vec3> mean_difference_error{};  ///< its standard error, from the seeds

    /// Returns 1 / (relMSE * CPU seconds). Twice the value is worth twice the machines.
    /// `preparation` is CPU time that the point does not include.
    double efficiency(double preparation = 0) const {
        return 1 / (relmse * (preparation + cpu_seconds));
    }
};

/// The power law fitted to points.
struct Fit {
    double slope = 0;  ///< of log MSE over log time: -1 for independent samples of equal cost
    double floor = 0;  ///< MSE that remains for any time: bias, or noise of the reference
};

/// Convergence of one configuration.
struct Curve {
    std::string name;  ///< "whitted, sobol, bvh"
    std::string sampler, integrator, backend;
    std::vector<Point> points{};
    std::optional<Fit> fit{};  ///< nothing if there are too few points
    int seeds = 0;             ///< number of images that the points are the means of
    double preparation = 0;    ///< CPU seconds before rendering: starting, reading, building
    /// Reasons, each beginning with the path, why images of the scene were replaced.
    std::vector<std::string> replaced_images{};

    /// Returns 1 / (MSE * CPU seconds) of the last point. Twice the value is worth twice the
    /// machines.
    double efficiency() const;
};

/// Convergence of another program's image; its times are those of whole processes.
struct ForeignCurve {
    std::string program;
    std::vector<Point> points;  ///< by CPU seconds
};

/// Fits the slope to the points from 4 samples on. The floor is what the last of them have above c
/// / samples, the slowest convergence of an unbiased image; 0 if they are not above. Over time,
/// falling costs of a sample would hide a floor. Returns nothing for fewer than three points.
std::optional<Fit> fit(const std::vector<Point>& points);

}  // namespace etalon::convergence
