// fuzz_rays: random scenes of few primitives and difficult numbers, edited at random, through all
// exact backends and the oracle. Ends with status 1 at the first difference, which it prints as a
// scene and a ray.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "tests/fuzz/rays/adversarial_rays.h"
#include "tests/fuzz/rays/adversarial_scene.h"
#include "tests/fuzz/rays/edits.h"
#include "tests/fuzz/rays/shrink.h"

namespace etalon::fuzz {
namespace {

/// The oracle takes as long as all backends together, so it checks every third scene only.
constexpr std::uint64_t scenes_for_oracle = 3;

struct Plan {
    std::uint64_t seed = 1, first = 0;
    double rays = 1e5, seconds = infinity;
    std::size_t rays_of_scene = 256;
    bool keep_going = false;
};

struct Counts {
    std::uint64_t scenes = 0, rays = 0, edited = 0, oracle = 0, undecided = 0, differences = 0;
};

void report(const Plan& plan, std::uint64_t number, const Shrunk& shrunk) {
    std::cout << to_text(shrunk) << "# to repeat it: fuzz_rays --seed " << plan.seed << " --scene "
              << number << " --rays 1\n"
              << std::flush;
}

/// Tests one scene; returns whether there was no difference.
bool test_scene(const Plan& plan, std::uint64_t number, Counts& counts) {
    Random random(plan.seed, number);
    const AdversarialNumbers numbers(static_cast<Palette>(random.index(palettes)), random);
    const Scene scene = adversarial_scene(numbers);
    const std::vector<Ray> rays = adversarial_rays(scene, plan.rays_of_scene, numbers);
    const std::vector<Hit> hits = reference_hits(scene, rays);
    counts.rays += rays.size();
    ++counts.scenes;
    auto finding = find_disparity(scene, rays, hits);
    if (!finding && number % scenes_for_oracle == 0) {
        counts.oracle += rays.size();
        finding = find_error(scene, rays, hits, counts.undecided);
    }
    if (finding) {
        report(plan, number, shrunk(scene, *finding, find_difference));
        return false;
    }
    const auto edit = edited(scene, rays, hits, numbers);
    if (!edit) return true;
    counts.edited += edit->rays.size();
    finding = find_change(*edit);
    if (finding) report(plan, number, {edit->scene, *finding});
    return !finding;
}

Counts test_scenes(const Plan& plan) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    Counts counts;
    for (std::uint64_t i = plan.first;
         static_cast<double>(counts.rays) < plan.rays && seconds() < plan.seconds; ++i) {
        if (test_scene(plan, i, counts)) continue;
        ++counts.differences;
        if (!plan.keep_going) break;
    }
    return counts;
}

int run(int argc, char** argv) {
    Plan plan;
    CLI::App app("Compares the answers of all exact backends and the oracle on random scenes");
    app.add_option("--seed", plan.seed, "Random seed");
    app.add_option("--scene", plan.first, "Number of the first scene");
    app.add_option("--rays", plan.rays, "Rays to test, in all");
    app.add_option("--seconds", plan.seconds, "Time limit");
    app.add_flag("--keep-going", plan.keep_going, "Do not end at the first difference");
    CLI11_PARSE(app, argc, argv);
    const Counts counts = test_scenes(plan);
    std::cout << "scenes " << counts.scenes << ", rays " << counts.rays << ", in edited scenes "
              << counts.edited << ", by the oracle " << counts.oracle << ", undecided "
              << counts.undecided << ", differences " << counts.differences << "\n";
    return counts.differences == 0 ? 0 : 1;
}

}  // namespace
}  // namespace etalon::fuzz

int main(int argc, char** argv) {
    return etalon::fuzz::run(argc, argv);
}
