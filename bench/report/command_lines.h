// The command lines that measure what the report's figures show, one by one.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"
#include "bench/report/settings.h"

namespace etalon::bench_report {

/// The whole report.
std::string command_of(const Settings& settings);

/// All scenes, or one.
std::string speed_command(const Settings& settings);
std::string speed_command(const Settings& settings, const std::string& scene);
std::string builds_command(const Settings& settings, const std::string& scene);

/// All hard cases, or those of a shape.
std::string accuracy_command(const Settings& settings);
std::string accuracy_command(const Settings& settings, const std::vector<accuracy::Row>& rows,
                             const std::string& shape);

/// All classic scenes.
std::string spd_command(const Settings& settings);

/// All frames of an origin.
std::string frames_command(const Settings& settings, FrameOrigin origin);

std::string image_command(const ImageRequest& request);

std::string convergence_command(const Settings& settings, const ConvergenceRequest& request);

/// Any scene that other programs rendered.
std::string foreign_command(const Settings& settings);

}  // namespace etalon::bench_report
