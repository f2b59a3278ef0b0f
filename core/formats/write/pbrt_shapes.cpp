#include "core/formats/write/pbrt_shapes.h"

#include <bit>
#include <numbers>

#include "core/formats/write/text.h"
#include "core/numerics/transforms.h"

namespace etalon {
namespace {

/// Rounds each number as PBRT stores it: 90 degrees stay 90 although they were radians.
float rounded(double number) {
    return static_cast<float>(number) + 0.0F;
}

std::string number(std::string_view name, double value) {
    return fmt::format(" \"float {}\" [ {} ]", name, rounded(value));
}

std::string point(std::string_view name, const Vec3& p) {
    return fmt::format(" \"point {}\" [ {} {} {} ]", name, rounded(p.x), rounded(p.y),
                       rounded(p.z));
}

/// Returns the two ends of the line from which a hyperboloid is swept.
std::string line_of(const Revolved& s) {
    const Profile& p = s.profile;
    const auto end = [&](double z) {
        const Vec2 at = s.sector.from(z);
        return Vec3(at.x, at.y, z);
    };
    return point("p1", end(p.falls ? p.high : p.low)) + point("p2", end(p.falls ? p.low : p.high));
}

/// Returns the radius and the heights of a statement, for a unit shape.
std::string heights_of(const Profile& p) {
    return number("radius", 1) + number("zmin", p.low) + number("zmax", p.high);
}

bool has_squares(const Revolved& s, const std::array<double, 3>& squares) {
    return s.profile.squares == squares;
}

/// Returns a statement for the surface moved by `height` along z, without its sector.
struct Unturned {
    std::string shape;
    double height = 0;
};

/// Finds the shape by the kind of its profile; core/scene/profiles.h lists them.
std::optional<Unturned> unturned(const Revolved& s) {
    const Profile& p = s.profile;
    switch (p.along) {
        case Profile::Along::radius:
            return Unturned{"\"disk\"" + number("radius", p.high) + number("innerradius", p.low)};
        case Profile::Along::angle:
            return Unturned{"\"sphere\"" + heights_of(p)};
        case Profile::Along::line:
            return Unturned{"\"hyperboloid\"" + line_of(s)};
        case Profile::Along::height:
            break;
    }
    if (has_squares(s, {1, 0, 0})) return Unturned{"\"cylinder\"" + heights_of(p)};
    if (has_squares(s, {0, 1, 0}) && p.high == 1) return Unturned{"\"paraboloid\"" + heights_of(p)};
    if (has_squares(s, {0, 0, 1}) && p.low == -1 && p.high == 0) {
        return Unturned{"\"cone\"" + number("radius", 1) + number("height", 1), -1};
    }
    return std::nullopt;
}

constexpr std::array<std::string_view, 3> type_names = {"flat", "ribbon", "cylinder"};

}  // namespace

std::optional<PbrtShape> to_pbrt(const Revolved& surface) {
    const std::optional<Unturned> found = unturned(surface);
    if (!found) return std::nullopt;
    const double degrees = surface.sector.angle / (std::numbers::pi / 180);
    return PbrtShape{surface.to_world * translation({0, 0, found->height}),
                     "Shape " + found->shape + number("phimax", degrees)};
}

PbrtShape to_pbrt(const StoredCurve& part) {
    const BezierCurve& c = part.curve;
    std::string text = fmt::format("Shape \"curve\" \"string type\" [ \"{}\" ]",
                                   type_names[static_cast<std::size_t>(c.type)]);
    text += number("width0", c.widths[0]) + number("width1", c.widths[1]);
    text += fmt::format(" \"integer splitdepth\" [ {} ] \"point P\" [",
                        std::countr_zero(part.part.count));
    for (const Vec3f& p : c.points) text += fmt::format(" {}", Vec3(p));
    if (c.type == CurveType::ribbon) {
        text += fmt::format(" ] \"normal N\" [ {} {}", Vec3(c.normals[0]), Vec3(c.normals[1]));
    }
    return {part.place.to_world, text + " ]"};
}

}  // namespace etalon
