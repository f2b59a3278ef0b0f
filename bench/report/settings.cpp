#include "bench/report/settings.h"

#include <limits>

#include "bench/speed/contender.h"
#include "bench/speed/pinned.h"

namespace etalon::bench_report {
namespace {

/// `none` tests every primitive against every ray: the report does not wait for it.
std::vector<std::string> all_but_none() {
    return {"grid", "bvh", "embree", "embree-builtin"};
}

}  // namespace

Settings quick_settings() {
    Settings s;
    s.name = "quick";
    s.seconds_limit = 150;
    s.speed_scenes = {"terrain:50000", "flake:50000",  "soup:100000",  "stadium:30000",
                      "slivers:10000", "spheres:1000", "spheres:20000"};
    s.plan = {speed::with_yardsticks(all_but_none()),   {1},    3, 0.2,
              {"camera", "bounce", "shadow", "random"}, 1 << 15};
    s.accuracy_backends = all_but_none();
    s.case_rays = 1024;
    s.case_seconds = 0.1;
    s.spd_scenes = {{"sphereflake", 4}, {"gears", 4}, {"mountain", 6},
                    {"rings", 7},       {"tetra", 6}, {"tree", 11}};
    s.spd_backends = all_but_none();
    s.pictures = {{"showcase.p3f", 480, 270, 4},
                  {"features/glass.p3f", 480, 320, 4},
                  {"features/soft_shadows.p3f", 480, 320, 4},
                  {"features/meshes.p3f", 480, 320, 4}};
    return s;
}

Settings full_settings() {
    Settings s = quick_settings();
    s.name = "full";
    s.seconds_limit = std::numeric_limits<double>::infinity();
    s.speed_scenes = {"terrain", "flake", "soup", "stadium", "slivers", "spheres:1000", "spheres"};
    if (speed::usable_cores() > 1) s.plan.threads.push_back(speed::usable_cores());
    s.plan.repeats = 5;
    s.plan.oracle_seconds = 1;
    s.plan.max_rays = 1 << 18;
    s.case_rays = 100'000;
    s.case_seconds = 5;
    for (PictureRequest& picture : s.pictures) picture.samples = 64;
    return s;
}

}  // namespace etalon::bench_report
