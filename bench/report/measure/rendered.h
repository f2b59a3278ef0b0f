// A scene rendered, with the time that it took.
#pragma once

#include "app/stopwatch.h"
#include "bench/report/tasks.h"
#include "core/render/renderer.h"

namespace etalon::bench_report {

struct Rendered {
    Rendering rendering;
    Duration build, render;
    std::size_t bytes = 0;  ///< of the accelerator
};

/// The whole frame, as the scene asks for it.
Rendered rendered(const Scene& scene, const std::string& backend, const Context& context);

}  // namespace etalon::bench_report
