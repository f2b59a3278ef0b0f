#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <sstream>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/hit_text.h"
#include "app/common/output.h"
#include "app/replaced_images.h"
#include "app/scene_arguments.h"
#include "app/subcommands.h"
#include "core/formats/file_text.h"
#include "core/intersect/kernels.h"

namespace etalon {
namespace {

/// Numbers of a ray. The time is a part of that between the shutter's opening and closing.
constexpr std::string_view ray_format = "ox oy oz dx dy dz [tmin tmax [time]]";

struct TraceArguments {
    SceneArguments scene;
    std::string rays, output = "-", backend;
    bool shadow = false;
};

/// The numbers of one line; what is behind `#` is a comment. False for anything that is no number.
bool parse_numbers(const std::string& line, std::vector<double>& numbers) {
    numbers.clear();
    const std::string text = line.substr(0, line.find('#'));
    const char* at = text.c_str();
    while (true) {
        at += std::strspn(at, " \t\r");
        if (*at == 0) return true;
        char* end = nullptr;
        numbers.push_back(std::strtod(at, &end));  // decimal and hexadecimal floats
        if (end == at || (*end != 0 && std::strchr(" \t\r", *end) == nullptr)) return false;
        at = end;
    }
}

bool complain(const TraceArguments& a, int line, const char* what) {
    print_message("{}:{}:1: error: {}; expected '{}'\n", a.rays, line, what, ray_format);
    return false;
}

bool read_rays(const TraceArguments& a, std::istream& in, std::vector<Ray>& rays) {
    std::vector<double> n;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (!parse_numbers(line, n)) return complain(a, number, "not a number");
        if (n.empty()) continue;
        if (n.size() != 6 && n.size() != 8 && n.size() != 9) {
            return complain(a, number, "wrong count of numbers");
        }
        Ray ray{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
        if (n.size() >= 8) ray.tmin = n[6], ray.tmax = n[7];
        if (n.size() == 9) {
            if (!(n[8] >= 0 && n[8] < 1)) return complain(a, number, "time outside of [0, 1)");
            ray.set_time(shutter_time(n[8]));
        }
        rays.push_back(ray);
    }
    return true;
}

bool read_rays(const TraceArguments& a, std::vector<Ray>& rays) {
    const FileText file = read_file(a.rays);
    if (!file.error.empty()) {
        print_message("{}: error: {}\n", a.rays, file.error);
        return false;
    }
    std::istringstream in{std::string(file.text())};
    return read_rays(a, in, rays);
}

std::string describe(const Scene& scene, const Ray& ray, const std::optional<Hit>& hit) {
    if (!hit) return "miss\n";
    const Vec3 n = surface_at(scene.geometry, ray, *hit).normal;
    return fmt::format("{} {:.17g} {:.17g} {:.17g}\n", hit_text(scene.geometry, *hit), n.x, n.y,
                       n.z);
}

int trace(const TraceArguments& a) {
    if (a.rays == "-" && a.scene.path == "-") {
        print_message("etalon: error: the scene and the rays cannot both be standard input\n");
        return exit_usage;
    }
    LoadedScene loaded = load(a.scene);
    if (!loaded.scene) return loaded.status;
    if (!make_cut_outs(*loaded.scene, a.scene)) return exit_unusable;
    const Scene& scene = *loaded.scene;
    std::vector<Ray> rays;
    if (!read_rays(a, rays)) return exit_unusable;
    if (a.shadow) {
        for (Ray& ray : rays) ray.set_shadow();
    }
    if (!a.backend.empty()) loaded.settings.backend = a.backend;
    const auto intersector = chosen_backend(loaded.settings).build(scene.geometry);
    if (!intersector) return exit_unusable;
    std::string text;
    for (const Ray& ray : rays) text += describe(scene, ray, intersector->closest(ray));
    return write_text(a.output, text) ? exit_done : exit_not_written;
}

}  // namespace

Action declare_trace(Options& options) {
    auto a = std::make_shared<TraceArguments>();
    declare_scene(options, a->scene);
    options
        .add("--rays", a->rays,
             fmt::format("File with one ray per line, '{}', decimal or hexadecimal; - is standard "
                         "input",
                         ray_format))
        .value("FILE")
        .required();
    options.add_flag("--shadow", a->shadow,
                     "The rays are shadow rays: they pass where a shadowalpha is 0, too");
    options
        .add("-o,--output", a->output,
             "File for the hits, one line per ray (default: standard output)")
        .value("FILE");
    options
        .add("-b,--backend", a->backend,
             "Backend that finds the hits (default: the scene's, else bvh)")
        .one_of(backend_names());
    return [a] { return trace(*a); };
}

}  // namespace etalon
