// All results of a report; its sections are views of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/common/stopwatch.h"
#include "bench/accuracy/error_stats.h"
#include "bench/convergence/equal_error.h"
#include "bench/frames/frame_figures.h"
#include "bench/report/settings.h"
#include "bench/speed/figures.h"
#include "core/integrators/ray_counts.h"

namespace etalon::bench_report {

/// Returns the local time: "2026-11-21 23:08".
std::string date_now();

/// Figures in order of measurement, and the time of the last one.
template <class T>
struct Measured {
    void add(T figures) {
        list.push_back(std::move(figures));
        date = date_now();
    }
    std::vector<T> list;
    std::string date;
};

/// Machine and software on which the results were measured.
struct Machine {
    std::string processor, system, compiler, flags, version, commit, embree, embree_isa;
    int cores = 0;
    double memory_bytes = 0;
    double load = 0;  ///< load average of the last minute when the run began
};

/// A classic scene by one backend.
struct SpdRun {
    std::string backend;
    Duration build, render;
    std::size_t bytes = 0;  ///< of the accelerator
    RayCounts counts;
};

struct SpdFigures {
    std::string family;
    std::int64_t size = 0;
    std::size_t primitives = 0;
    double parse = 0;  ///< CPU seconds
    std::vector<SpdRun> runs;
};

/// An image's errors over its samples.
struct ConvergenceFigures {
    ConvergenceRequest request;
    std::string reference;  ///< description of the reference
    std::vector<convergence::Curve> curves;
};

/// A scene's curves beside those of other programs.
struct ForeignFigures {
    std::string scene;    ///< without the folder of the table, and extension
    std::string missing;  ///< why it was not compared; empty if it was
    std::string reference;
    Imath::V2i size{0, 0};
    convergence::Curve own{};
    std::vector<convergence::ForeignCurve> foreign{};
    std::vector<convergence::CurveComparison> comparisons{};
    /// True if the means of the images say that both programs render the same.
    bool is_same = false;
};

struct ImageFigures {
    std::string scene, command;
    int width = 0, height = 0;
    std::size_t primitives = 0;
    Duration render;
    struct Layer {
        std::string title, png;
    };
    std::vector<Layer> layers;  ///< the image, and other data of each pixel
};

/// A whole frame.
struct MeasuredFrame {
    FrameOrigin origin;
    frames::FrameFigures figures;
};

struct Results {
    Settings settings;
    std::string begun;
    std::string missing;  ///< why not all was measured; empty if it was
    Machine machine;
    Measured<ImageFigures> images;
    Measured<speed::SceneFigures> scenes;
    Measured<accuracy::Row> rows;
    Measured<MeasuredFrame> frames;
    Measured<SpdFigures> spd;
    Measured<ConvergenceFigures> convergence;
    Measured<ForeignFigures> foreign;
};

}  // namespace etalon::bench_report
