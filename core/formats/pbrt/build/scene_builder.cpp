#include "core/formats/pbrt/build/scene_builder.h"

#include <algorithm>

namespace etalon::pbrt {

ColorSlot SceneBuilder::color(const Parameters& p, std::string_view name) {
    if (const auto texture = p.texture(name)) return {p.color(name), texture_numbers[*texture]};
    return {p.color(name)};
}

NumberSlot SceneBuilder::number(const Parameters& p, std::string_view name) {
    if (const auto texture = p.texture(name)) return {p.number(name), texture_numbers[*texture]};
    return {p.number(name)};
}

std::optional<Affine> SceneBuilder::affine(std::uint32_t transform, const FileLoc& loc) {
    const Matrix4 m = frame.transforms[transform];
    const Affine map = affine_part(m);
    if (is_affine(m) && map.determinant() != 0) return map;
    warn(loc, "transform", "left out: its transform is {}",
         is_affine(m) ? "singular" : "a projection");
    return std::nullopt;
}

PlaceInTime SceneBuilder::place_in_time(const Affine& start, const Affine& end) const {
    if (start == end) return {start, std::nullopt};
    const Parameters& p = frame.camera.parameters;
    const auto [open, close] = std::minmax({p.number("shutteropen"), p.number("shutterclose")});
    const AnimatedTransform motion(
        start, end, {frame.transform_times[0], frame.transform_times[1], open, close});
    if (!motion.times().see_motion()) return {motion.at(0), std::nullopt};
    return {motion.at(0), motion};
}

std::optional<PlaceInTime> SceneBuilder::place_in_time(TransformPair pair, const FileLoc& loc) {
    const std::optional<Affine> start = affine(pair.start, loc);
    if (!start) return std::nullopt;
    if (!pair.is_animated()) return PlaceInTime{*start, std::nullopt};
    const std::optional<Affine> end = affine(pair.end, loc);
    if (!end) return std::nullopt;
    return place_in_time(*start, *end);
}

Affine affine_part(const Matrix4& m) {
    const auto column = [&](std::size_t k) { return Vec3(m[0][k], m[1][k], m[2][k]); };
    return {column(0), column(1), column(2), column(3)};
}

Affine inverse(const Affine& map) {
    const double d = map.determinant();
    const Vec3 a = map.y.cross(map.z) / d, b = map.z.cross(map.x) / d, c = map.x.cross(map.y) / d;
    Affine result{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, Vec3(0)};
    result.origin = -result.vector(map.origin);
    return result;
}

void warn_of_stand_in(SceneBuilder& b, const Plugin& plugin) {
    if (plugin.type->stand_in.empty()) return;
    b.warn(plugin.where, "stand-in", "{} \"{}\" is not rendered yet; {} stands in for it",
           to_string(plugin.type->category), plugin.type->name, plugin.type->stand_in);
}

}  // namespace etalon::pbrt
