#include "tests/bench/report_results.h"

#include <cmath>

#include "tests/accuracy/report_rows.h"

namespace etalon::test {
namespace {

using namespace bench_report;

const std::string adversarial = "<b>\"a\" & b</b>";

speed::Runs runs(double seconds) {
    speed::Runs r;
    r.repeats = {{seconds, seconds}, {1.1 * seconds, 1.1 * seconds}};
    r.ratio = {1 / seconds, 0.05};
    r.ratio_robust = r.cpu_scaling = r.wall_scaling = {1, 0};
    return r;
}

speed::SceneFigures scene() {
    speed::SceneFigures figures{adversarial, 1234567, "sphere", {}, {{"camera", 1000, false, {}}}};
    double seconds = 0.5;
    for (const char* name :
         {"grid", "bvh", "embree", "embree-user", "embree-builtin", "embree-builtin-robust"}) {
        figures.builds.push_back({name, "avx2", 64.25, {runs(seconds)}});
        speed::Errors errors;
        errors.sample.rays = 2174;
        errors.sample.false_hits = name == std::string("embree-builtin") ? 12 : 0;
        errors.disputed.rays = 30;
        errors.disputed.false_misses = name == std::string("embree-builtin") ? 7 : 0;
        figures.kinds[0].tracers.push_back({name, {runs(seconds)}, errors});
        seconds += 0.25;
    }
    return figures;
}

frames::FrameFigures frame() {
    frames::FrameFigures f;
    f.scene = adversarial;
    f.backend = "bvh";
    f.width = f.height = 100;
    f.samples = 4;
    f.rays = 123456;
    f.intersection = 0.5;
    f.render = 0.8;
    return f;
}

SpdFigures spd() {
    RayCounts counts;
    counts.camera = 263169;
    counts.camera_hits = 49950;
    RayCounts other = counts;
    other.shadow = 1;
    return {"tetra",
            6,
            16385,
            0.01,
            {{"bvh", {0.1, 0.1}, {0.2, 0.3}, 4096, counts},
             {"embree-builtin", {0.1, 0.1}, {0.2, 0.3}, 4096, other}}};
}

convergence::Curve curve(const std::string& name, double slope) {
    convergence::Curve c;
    c.name = c.sampler = c.backend = name;
    c.seeds = 3;
    for (double samples = 1; samples <= 16; samples *= 2) {
        const double error = std::pow(samples, -slope);
        c.points.push_back({samples, 0.1 * samples, error, error, 0.9 * error, 1.2 * error});
    }
    c.fit = convergence::fit(c.points);
    return c;
}

/// Two scenes of another program, one of them not compared.
void add_foreign(Results& results) {
    results.settings.foreign_table = adversarial;
    ForeignFigures f;
    f.scene = f.reference = adversarial;
    f.own = curve("sobol, bvh", 1);
    f.own.preparation = 0.1;
    const auto point = [](double samples, double seconds, double relmse) {
        convergence::Point p{samples, seconds, relmse, relmse};
        p.mean_difference = Vec3(0.001);
        return p;
    };
    f.foreign = {{adversarial, {point(4, 2, 0.5), point(0, 40, 0.01)}}};
    f.comparisons = convergence::compare({f.own}, f.foreign);
    f.is_same = true;
    results.foreign.add(f);
    ForeignFigures missing;
    missing.scene = "other";
    missing.missing = adversarial;
    results.foreign.add(missing);
}

/// The page does not check it; a browser shows a broken image of the right size.
const std::string no_png = "\x89PNG";

}  // namespace

Results sample_results() {
    Results results;
    results.settings = quick_settings();
    results.begun = date_now();
    results.machine.processor = adversarial;
    results.machine.flags = "-O3 " + std::string(200, 'x');
    results.scenes.add(scene());
    for (accuracy::Row& row : accuracy::sample_rows()) results.rows.add(std::move(row));
    for (const FrameOrigin origin :
         {FrameOrigin::shipped, FrameOrigin::family, FrameOrigin::given}) {
        results.frames.add({origin, frame()});
    }
    results.spd.add(spd());
    ConvergenceFigures convergence;
    convergence.request.scene = convergence.reference = adversarial;
    convergence.curves = {curve("sobol, bvh", 1.5), curve(adversarial, 1)};
    results.convergence.add(std::move(convergence));
    add_foreign(results);
    ImageFigures image;
    image.scene = adversarial;
    image.command = "build/bin/etalon render " + adversarial;
    image.width = image.height = 480;
    image.layers = {{adversarial, no_png}};
    results.images.add(std::move(image));
    return results;
}

}  // namespace etalon::test
