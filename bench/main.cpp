// etalon-bench: measures accelerators.
#include "bench/bench_subcommands.h"

namespace {

constexpr etalon::Command commands[] = {
    {"speed", "Rays a second, build time and memory of every backend", etalon::declare_speed},
    {"accuracy", "The hard cases, by the million, against what is true", etalon::declare_accuracy},
    {"convergence", "The error of a picture against the time it takes",
     etalon::declare_convergence},
    {"report", "All of it, on one page: DIR/index.html", etalon::declare_report},
};

}  // namespace

int main(int argc, char** argv) {
    return etalon::run_program("etalon-bench", "Etalon's accelerator laboratory", commands, argc,
                               argv);
}
