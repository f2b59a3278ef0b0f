// Parameters of a report: scenes, rays, samples and repeats.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/convergence/foreign_table.h"
#include "bench/speed/speed_config.h"

namespace etalon::bench_report {

struct SpdScene {
    std::string family;
    std::int64_t size;
};

/// Origin of the scene of a frame: one of this project's, one of its families, or a file named on
/// the command line.
enum class FrameOrigin { shipped, family, given };

struct FrameRequest {
    FrameOrigin origin;
    std::string scene;      ///< path below the folder of scenes; a family; a file
    std::int64_t size = 0;  ///< of a family
    int width = 0;          ///< in pixels; 0: the scene's
    int samples = 0;        ///< per pixel; 0: the scene's
};

struct ImageRequest {
    std::string scene;  ///< below the folder of scenes
    int width, height;
    int samples;        ///< per pixel, of the image shown
    int fewer_samples;  ///< per pixel, of the image compared with it
};

struct ConvergenceRequest {
    std::string scene;  ///< below the folder of scenes
    int width = 0, height = 0;
    int samples = 0;  ///< per pixel, at the end of the curves
};

/// A scene that other programs rendered.
struct ForeignRequest {
    std::string scene;  ///< the file
    std::vector<convergence::ForeignImage> images;
};

/// Returns the approximate time of a scene's sample, in microseconds on a core of 2026.
double microseconds_of_sample(const std::string& scene);

struct Settings {
    std::string name;               ///< "quick" or "full"
    std::string folder = "report";  ///< of the page
    double seconds_limit = 0;       ///< wall time after which the rest is left out; 0 is no limit

    std::vector<std::string> speed_scenes;
    speed::SpeedConfig speed_config;

    std::vector<std::string> accuracy_backends;
    std::uint64_t case_rays;
    double case_seconds;  ///< wall time; a case that takes longer gets fewer rays

    std::vector<FrameRequest> frames;
    int frame_repeats = 0;

    std::vector<SpdScene> spd_scenes;
    std::vector<std::string> spd_backends;

    std::vector<ImageRequest> images;
    std::vector<ConvergenceRequest> convergence;
    std::vector<std::string> convergence_backends;
    int convergence_seeds = 0;

    std::string foreign_table;  ///< file that lists the images below; empty if there are none
    std::vector<ForeignRequest> foreign;
    int foreign_samples = 0;  ///< per pixel, at the end of our curves
    int foreign_seeds = 0;
};

Settings quick_settings();
Settings full_settings();

/// Adds scene files, and those in folders, to the frames, and the time that they take to the limit.
/// Returns why one cannot be added, or an empty string.
std::string add_frames(const std::vector<std::string>& paths, Settings& settings);

/// Adds the scenes of a table of other programs' images, and the time that they take to the limit.
/// Returns what is wrong with the table, or an empty string.
std::string add_foreign(const std::string& table, Settings& settings);

/// Returns the approximate time of measuring a frame, in seconds of wall time. That of a scene's
/// own resolution is unknown before it is loaded.
double seconds_for(const FrameRequest& request, const Settings& settings);

/// Returns the approximate time of comparing a scene with other programs, in seconds of wall time.
double seconds_for(const ForeignRequest& request, const Settings& settings);

}  // namespace etalon::bench_report
