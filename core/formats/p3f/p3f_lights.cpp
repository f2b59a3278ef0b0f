// light punctual, light quad, and the old dialect's l.
#include <algorithm>
#include <array>

#include "core/formats/nearest_name.h"
#include "core/formats/p3f/p3f_loader.h"

namespace etalon::p3f {
namespace {

/// Reads the corner and the ends of the two edges that start there. (The course's document defines
/// the second edge wrongly; its programs do this.)
void read_quad_light(Loader& loader) {
    constexpr std::int64_t most_samples = 1 << 16;
    Reader& in = loader.in;
    const Vec3 corner = in.vector("corner");
    const Color color = in.color("colour");
    const Vec3 end1 = in.vector("first edge's end"), end2 = in.vector("second edge's end");
    const std::size_t offset = in.tokens().offset();
    const std::int64_t samples = in.integer("number of samples");
    if (!in.ok()) return;
    const std::int64_t taken = std::clamp<std::int64_t>(samples, 1, most_samples);
    if (taken != samples) {
        in.warn_at(offset, "range", "expected 1 to {} light samples, found {}; taken as {}",
                   most_samples, samples, taken);
    }
    const QuadLight light{corner, end1 - corner, end2 - corner, color, static_cast<int>(taken)};
    if (!is_finite(light.edge1) || !is_finite(light.edge2)) {
        return loader.skip_degenerate("its edges are too long");
    }
    loader.scene.whitted().lights.emplace_back(light);
}

}  // namespace

void read_point_light(Loader& loader) {
    const Vec3 position = loader.in.vector("position");
    const Color color = loader.in.color("colour");
    if (loader.in.ok()) loader.scene.whitted().lights.emplace_back(PointLight{position, color});
}

void read_light(Loader& loader) {
    static constexpr std::array<std::string_view, 2> types = {"punctual", "quad"};
    Reader& in = loader.in;
    const std::string_view type = in.tokens().peek();
    if (type != types[0] && type != types[1]) {
        in.fail_at(in.tokens().offset(), "syntax",
                   "expected punctual or quad after 'light', found {}{}", in_quotes(type),
                   did_you_mean(type, types));
        return;
    }
    in.tokens().next();
    type == types[0] ? read_point_light(loader) : read_quad_light(loader);
}

}  // namespace etalon::p3f
