#pragma once

#include <cstdint>
#include <string>

namespace etalon::frames {

/// Times of the stages of one frame on one thread, in seconds of processor time: medians.
struct FrameFigures {
    std::string scene, backend;
    int width = 0, height = 0, samples = 0;
    std::uint64_t rays = 0;
    int repeats = 0;          ///< number of measurements of the stages
    double start = 0;         ///< the process until main
    double load = 0;          ///< reading the scene file, without its images
    double build = 0;         ///< the backend's structure
    double images = 0;        ///< what the first rendering takes longer, as it reads images
    double camera = 0;        ///< generating the camera rays
    double intersection = 0;  ///< finding the hits of the frame's rays, and nothing else
    double film = 0;          ///< adding the samples up
    double write = 0;         ///< encoding and writing an EXR
    double render = 0;        ///< the whole rendering, from camera rays to film
    /// Times as fast as embree-builtin, or as the first backend if that does not take part.
    double ratio = 1;

    /// Returns the time of the rendering beside the stages that are measured alone: surfaces,
    /// lights, and the rays that they spawn.
    double shading() const { return render - camera - intersection - film; }

    /// Returns the time of the rendering over that of its intersections.
    double overhead() const { return render / intersection; }

    /// Returns the nanoseconds of the rendering for each of its rays.
    double nanoseconds() const { return 1e9 * render / static_cast<double>(rays); }
};

}  // namespace etalon::frames
