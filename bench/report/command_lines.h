// The command lines that reproduce the report's figures.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"
#include "bench/report/settings.h"

namespace etalon::bench_report {

/// Returns the command of the whole report.
std::string command_of(const Settings& settings);

/// Return the commands for all scenes, or for one.
std::string speed_command(const Settings& settings);
std::string speed_command(const Settings& settings, const std::string& scene);
std::string builds_command(const Settings& settings, const std::string& scene);

/// Return the commands for all hard cases, or for those of a shape.
std::string accuracy_command(const Settings& settings);
std::string accuracy_command(const Settings& settings, const std::vector<accuracy::Row>& rows,
                             const std::string& shape);

/// Returns the command for all classic scenes.
std::string spd_command(const Settings& settings);

/// Returns the command for all frames of an origin.
std::string frames_command(const Settings& settings, FrameOrigin origin);

std::string image_command(const ImageRequest& request);

std::string convergence_command(const Settings& settings, const ConvergenceRequest& request);

/// Returns the command for any scene that other programs rendered.
std::string foreign_command(const Settings& settings);

}  // namespace etalon::bench_report
