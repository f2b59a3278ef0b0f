#include "tests/fuzz/rays/shrink.h"

#include <fmt/format.h>

#include <cstdlib>

#include "core/formats/write/write.h"

namespace etalon::fuzz {
namespace {

/// Returns the scene without an item. Instances are numbered after the primitives.
Scene without(const Scene& scene, std::uint32_t item) {
    Scene less = scene;
    Geometry& g = less.geometry;
    if (g.is_instance(item)) {
        g.instances.erase(g.instances.begin() + g.instance_number(item));
        return less;
    }
    std::vector<Primitive> list = g.primitives.list();
    list.erase(list.begin() + item);
    g.primitives = PrimitiveRuns(list);
    return less;
}

/// Returns a number rounded to so many significant digits.
double rounded(double x, int digits) {
    return std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr);
}

bool keep_if_different(Shrunk& best, const Scene& scene, const Ray& ray,
                       const FindDifference& find) {
    auto finding = find(scene, {ray});
    if (!finding) return false;
    best = {scene, *std::move(finding)};
    return true;
}

void drop_items(Shrunk& best, const FindDifference& find) {
    for (std::uint32_t item = 0; item < best.scene.geometry.item_count();) {
        const Scene less = without(best.scene, item);
        if (!keep_if_different(best, less, best.finding.ray, find)) ++item;
    }
}

void round_number(Shrunk& best, double& (*number)(Ray&, int), int k, const FindDifference& find) {
    for (int digits = 1; digits < 17; ++digits) {
        Ray ray = best.finding.ray;
        double& x = number(ray, k);
        if (!std::isfinite(x)) return;
        x = rounded(x, digits);
        if (keep_if_different(best, best.scene, ray, find)) return;
    }
}

void round_ray(Shrunk& best, const FindDifference& find) {
    for (int k = 0; k < 3; ++k) {
        round_number(
            best, [](Ray& r, int i) -> double& { return r.origin[i]; }, k, find);
        round_number(
            best, [](Ray& r, int i) -> double& { return r.direction[i]; }, k, find);
    }
    round_number(
        best, [](Ray& r, int) -> double& { return r.tmin; }, 0, find);
    round_number(
        best, [](Ray& r, int) -> double& { return r.tmax; }, 0, find);
}

}  // namespace

Shrunk shrunk(Scene scene, Finding finding, const FindDifference& find) {
    Shrunk best{std::move(scene), std::move(finding)};
    const Ray ray = best.finding.ray;
    keep_if_different(best, Scene(best.scene), ray, find);
    drop_items(best, find);
    round_ray(best, find);
    return best;
}

std::string to_text(const Shrunk& shrunk) {
    Scene scene = shrunk.scene;
    scene.whitted().materials.resize(1);
    const WrittenScene written = write_p3f(scene, {}, "");
    std::string text = written.text;
    for (const Primitive& p : scene.geometry.primitives)
        text += fmt::format("# is a {}\n", kind_name(p.kind));
    for (const Geometry& object : scene.geometry.objects) {
        for (const Primitive& p : object.primitives) {
            text += fmt::format("# has in an object a {}\n", kind_name(p.kind));
        }
    }
    for (const ConversionWarning& warning : written.lost) text += "# lost: " + warning.what + "\n";
    return fmt::format("{}# ray: {}\n# {}\n", text, to_string(shrunk.finding.ray),
                       shrunk.finding.text);
}

}  // namespace etalon::fuzz
