// etalon-bench: measures accelerators.
#include "bench/bench_subcommands.h"

namespace {

constexpr etalon::Command commands[] = {
    {"speed", "Measure rays per second, build time and memory of the backends",
     etalon::declare_speed},
    {"accuracy", "Measure errors on hard cases, against the oracle", etalon::declare_accuracy},
    {"convergence", "Measure the error of an image against render time",
     etalon::declare_convergence},
    {"frames", "Measure where the time of whole frames goes", etalon::declare_frames},
    {"report", "Run all measurements and write one page, DIR/index.html", etalon::declare_report},
};

}  // namespace

int main(int argc, char** argv) {
    return etalon::run_program("etalon-bench", "Etalon's accelerator laboratory", commands, argc,
                               argv);
}
