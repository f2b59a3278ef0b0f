#include "core/scene/profiles.h"
#include "core/test_rays/revolved_points.h"
#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

/// The targets are in the coordinates of the image.
ShapeCase revolved(const std::string& name, const Revolved& s) {
    const Affine& map = s.to_world;
    const double reach = std::max({1.0, std::abs(s.profile.low), std::abs(s.profile.high)});
    const double size = reach * (map.x.length() + map.y.length() + map.z.length());
    const double middle = s.profile.is_flat() ? 0 : 0.5 * (s.profile.low + s.profile.high);
    ShapeCase c{"revolved, " + name, {}, map.point({0, 0, middle}), size, true, {}, {}};
    c.scene.geometry.add(s, 0);
    const RevolvedPoints points(s);
    const auto add = [&](const char* what, auto&& point) {
        c.targets.push_back({what, [=](Random& random, const Vec3& from) {
                                 const Vec3 seen = s.frame.vector(from - map.origin);
                                 return s.frame.point(point(random, seen));
                             }});
    };
    add("surface", [=](Random& random, const Vec3&) { return points.on_surface(random); });
    add("axis", [=](Random& random, const Vec3&) { return points.on_axis(random); });
    add("rim", [=](Random& random, const Vec3&) {
        return points.on_rim(random.index(2) == 0 ? 1 : nearly_one(random), random);
    });
    add("silhouette", [=](Random& random, const Vec3& from) {
        return points.silhouette(from, nearly_one(random), random);
    });
    if (!s.sector.is_whole) {
        add("side", [=](Random& random, const Vec3&) {
            return points.on_side(random.index(2) == 0 ? 1 : nearly_one(random), random);
        });
    }
    if (points.has_tip()) {
        c.tips.push_back(map.point(points.tip()));
        add("tip", [=](Random& random, const Vec3&) {
            return points.tip() + std::pow(10.0, random.uniform(-18, 0)) * random.direction();
        });
    }
    return c;
}

}  // namespace

/// Each kind of profile, whole and partial, under maps of all kinds.
std::vector<ShapeCase> revolved_cases() {
    const Affine askew = rotation(), shear{{1, 0, 0}, {0.5, 1, 0}, {-2, 3, 1}};
    const Affine turned{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}};
    Affine distant = askew * scaling(1, 1, 0.5);
    distant.origin = far_away;
    const Sector whole(360), quarter(90), half_turn(180), most(300);
    // The line from (1, -0.5, -1) to (1, 0.5, 1).
    const Sector twisted(360, {{1, 0}, {0, 0.5}}), part(240, {{1, 0}, {0, 0.5}});
    Profile line = profiles::hyperboloid(1, 0.25, -1, 1);
    line.along = Profile::Along::line;
    return {
        revolved("sphere cut below", {askew, profiles::sphere(-0.25, 1), whole}),
        revolved("part of a sphere",
                 {askew * scaling(2, 2, 2), profiles::sphere(-0.5, 0.75), most}),
        revolved("part of a sphere, sheared", {shear, profiles::sphere(-1, 1), quarter}),
        revolved("cylinder", {Affine{}, profiles::cylinder(), whole}),
        revolved("cylinder askew", {askew * scaling(1, 1, 3), profiles::cylinder(), whole}),
        revolved("half a cylinder", {askew * scaling(1, 0.5, 3), profiles::cylinder(), half_turn}),
        revolved("quarter of a cylinder, needle",
                 {askew * scaling(1e-3, 1e-3, 10), profiles::cylinder(), quarter}),
        revolved("cylinder far from the origin", {distant, profiles::cylinder(), most}),
        revolved("cone", {Affine{}, profiles::cone(), whole}),
        revolved("cone askew", {askew * scaling(1, 1, 2), profiles::cone(), whole}),
        revolved("part of a cone, mirrored", {askew * scaling(-1, 1, 2), profiles::cone(), most}),
        revolved("paraboloid", {askew, profiles::paraboloid(0), whole}),
        revolved("part of a paraboloid", {shear, profiles::paraboloid(0.25), quarter}),
        revolved("hyperboloid", {askew, profiles::hyperboloid(0.25, 0.75, -1, 1), whole}),
        revolved("part of a hyperboloid",
                 {askew * scaling(1, 0.5, 2), profiles::hyperboloid(0.25, 0.75, -0.5, 1), most}),
        revolved("line turned about the axis", {askew, line, twisted}),
        revolved("part of a line turned about the axis", {askew, line, part}),
        revolved("disk", {shear, profiles::disk(0), whole}),
        revolved("sector of a disk", {askew, profiles::disk(0), quarter}),
        revolved("sector of a ring, far from the origin", {distant, profiles::disk(0.5), most}),
        revolved("condition 1e4", {askew * scaling(1, 0.5, 1e-4) * turned * shear,
                                   profiles::sphere(-0.5, 0.5), half_turn}),
    };
}

}  // namespace etalon
