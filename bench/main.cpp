// etalon-bench: measures accelerators.
#include "app/common/provenance.h"
#include "bench/bench_subcommands.h"
#include "bench/frames/process_start.h"

namespace {

constexpr etalon::Command commands[] = {
    {"speed",
     "Measure rays per second, build time and memory of the backends",
     etalon::declare_speed,
     {{{"--list", "List the scenes that have a name"},
       {"--scene terrain,scene.p3f --backends bvh,embree --rays camera --json speed.json",
        "Measure two backends with the camera rays of a named scene and of a file"}}}},
    {"accuracy",
     "Measure errors on hard cases, against the oracle",
     etalon::declare_accuracy,
     {{{"--list", "List the cases"},
       {"--case SPH --backends bvh,embree-builtin --rays 1e6 --json accuracy.json",
        "Measure two backends with the cases of spheres, a million rays each"}}}},
    {"convergence",
     "Measure the error of an image against render time",
     etalon::declare_convergence,
     {{{"scene.p3f --width 160 --spp 64 --json convergence.json",
        "Measure the error of up to 64 samples per pixel"},
       {"scene.p3f --samplers sobol --integrators ao --json convergence.json",
        "Measure ambient occlusion with one sampler"}}}},
    {"frames",
     "Measure where the time of whole frames goes",
     etalon::declare_frames,
     {{{"scene.p3f --json frames.json", "Measure a scene file as it is rendered"},
       {"terrain flake --backends bvh,embree-builtin --repeat 3 --json frames.json",
        "Measure two named scenes with two backends, three times each"}}}},
    {"report",
     "Run all measurements and write one page, DIR/index.html",
     etalon::declare_report,
     {{{"--quick", "Measure for two minutes, and write report/index.html"},
       {"-o results", "Measure everything, and write results/index.html"}}}},
};

}  // namespace

int main(int argc, char** argv) {
    etalon::frames::note_begin_of_main();
    return etalon::run_program(
        {"etalon-bench", "Etalon's accelerator laboratory", etalon::library_lines}, commands, argc,
        argv);
}
