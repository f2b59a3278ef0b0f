#include "core/test_rays/targets.h"

#include "core/intersect/placement.h"
#include "core/scene/bezier.h"
#include "core/test_rays/directions.h"
#include "core/test_rays/frustum.h"
#include "core/test_rays/outline.h"
#include "core/test_rays/quadric_points.h"
#include "core/test_rays/revolved_points.h"

namespace etalon {
namespace {

Vec3 silhouette(const Sphere& s, const Vec3& from, double finest, Random& random) {
    const Vec3 f = from - s.centre;
    const double distance = f.length();
    const Vec3 up = distance > 0 ? f / distance : Vec3(0, 0, 1);
    const double cosine = distance > s.radius ? s.radius / distance : 1;
    const Vec3 side = across(up, random.uniform(0, turn));
    const double reach = s.radius * nearly_one(finest, random);
    return s.centre + reach * (cosine * up + std::sqrt(1 - cosine * cosine) * side);
}

std::vector<Target> targets(const Sphere& s, double finest) {
    return {
        [=](const Vec3&, Random& random) { return s.centre + s.radius * in_ball(random); },
        [=](const Vec3&, Random& random) { return s.centre + s.radius * random.direction(); },
        [=](const Vec3& from, Random& random) { return silhouette(s, from, finest, random); },
    };
}

std::vector<Target> targets(const Cone& cone, double finest) {
    const Frustum f(cone);
    std::vector<Target> list = {
        [=](const Vec3&, Random& random) {
            const double s = random.uniform();
            return f.point(s, 1, random.uniform(0, turn));
        },
        [=](const Vec3&, Random& random) { return f.point(random.uniform(-0.1, 1.1), 0, 0); },
        [=](const Vec3&, Random& random) {
            const double end = random.index(2) == 0 ? 0 : 1, off = nearly_one(finest, random) - 1;
            return f.point(end + off, 1, random.uniform(0, turn));
        },
        [=](const Vec3& from, Random& random) {
            const double s = random.uniform(), reach = nearly_one(finest, random);
            return f.silhouette(s, reach, from, random.sign());
        },
    };
    if (cone.base_radius == 0 || cone.top_radius == 0) {
        const Vec3 apex = cone.base_radius == 0 ? cone.base : cone.top;
        list.emplace_back([=](const Vec3&, Random& random) {
            const double miss = random.magnitude(finest, 0);
            return apex + miss * (f.radius(0) + f.radius(1)) * random.direction();
        });
    }
    return list;
}

std::vector<Target> targets(const Box& box, double) {
    std::vector<Target> list;
    for (int fixed = 0; fixed < 4; ++fixed) {
        list.emplace_back(
            [=](const Vec3&, Random& random) { return on_faces(box, fixed, random); });
    }
    return list;
}

std::vector<Target> targets(const Plane& plane, double finest) {
    const Vec3 n = plane.normal.normalized();
    return {
        [=](const Vec3&, Random& random) { return plane.point + 10.0 * n.cross(random.in_cube()); },
        [=](const Vec3& from, Random& random) {
            const Vec3 level = from + n.cross(random.in_cube());
            const double off = random.magnitude(finest, 0);
            return level + off * random.in_cube();
        },
    };
}

std::vector<Target> targets(const Ring& ring, double finest) {
    const Vec3 n = ring.normal.normalized();
    const auto at = [=](double radius, Random& random) {
        return ring.centre + radius * across(n, random.uniform(0, turn));
    };
    return {
        [=](const Vec3&, Random& random) {
            return at(random.uniform(ring.inner, ring.outer), random);
        },
        [=](const Vec3&, Random& random) { return at(random.uniform(0, ring.inner), random); },
        [=](const Vec3&, Random& random) { return at(ring.inner, random); },
        [=](const Vec3&, Random& random) {
            const double rim = random.index(2) == 0 ? ring.inner : ring.outer;
            return at(rim * nearly_one(finest, random), random);
        },
    };
}

std::vector<Target> targets(const Quadric& quadric, double finest) {
    const QuadricPoints points(quadric);
    return {
        [=](const Vec3&, Random& random) { return points.in_clip(random); },
        [=](const Vec3&, Random& random) { return points.on_surface(random); },
        [=](const Vec3&, Random& random) { return points.on_rim(random); },
        [=](const Vec3& from, Random& random) {
            const double off = nearly_one(finest, random) - 1;
            return points.silhouette(from, off, random);
        },
    };
}

/// Returns the targets of a shape under a map, given those of the shape in the frame.
std::vector<Target> moved(const std::vector<Target>& targets, const Vec3& origin,
                          const LocalFrame& frame) {
    std::vector<Target> list;
    for (const Target& target : targets) {
        list.emplace_back([=](const Vec3& from, Random& random) {
            return frame.point(target(frame.vector(from - origin), random));
        });
    }
    return list;
}

std::vector<Target> targets(const Ellipsoid& e, double finest) {
    return moved(targets(Sphere{{0, 0, 0}, 1}, finest), e.to_world.origin, e.frame);
}

std::vector<Target> targets(const ClosedCylinder& c, double finest) {
    std::vector<Target> list = targets(Cone{{0, 0, 0}, {0, 0, 1}, 1, 1}, finest);
    list.emplace_back([](const Vec3&, Random& random) {
        const double cap = random.index(2) == 0 ? 0 : 1, radius = std::sqrt(random.uniform());
        return across({0, 0, 1}, random.uniform(0, turn)) * radius + Vec3(0, 0, cap);
    });
    return moved(list, c.to_world.origin, c.frame);
}

std::vector<Target> targets(const Revolved& s, double finest) {
    const RevolvedPoints points(s);
    std::vector<Target> list = {
        [=](const Vec3&, Random& random) { return points.on_surface(random); },
        [=](const Vec3&, Random& random) { return points.on_axis(random); },
        [=](const Vec3&, Random& random) {
            return points.on_rim(nearly_one(finest, random), random);
        },
        [=](const Vec3& from, Random& random) {
            return points.silhouette(from, nearly_one(finest, random), random);
        },
    };
    if (!s.sector.is_whole) {
        list.emplace_back([=](const Vec3&, Random& random) {
            return points.on_side(nearly_one(finest, random), random);
        });
    }
    if (points.has_tip()) {
        list.emplace_back([=](const Vec3&, Random& random) {
            return points.tip() + random.magnitude(finest, 0) * random.direction();
        });
    }
    return moved(list, s.to_world.origin, s.frame);
}

/// Points across a part of a curve, and beside the ends of its width, seen from the ray's origin.
std::vector<Target> targets(const StoredCurve& c, double finest) {
    const Curve curve(c);
    const auto at = [curve](const Vec3& from, double u, double across) {
        CubicPoints points;
        for (std::size_t i = 0; i < 4; ++i) points[i] = Vec3(curve.curve.points[i]);
        const CurveTransform place(curve.to_world);
        const Vec3 centre = blossom(points, u, u, u);
        const Vec3 sight = centre - place.vector(from - curve.to_world.origin);
        const double half = 0.5 * ((1 - u) * curve.curve.widths[0] + u * curve.curve.widths[1]);
        const Vec3 side = derivative_of(points, u).cross(sight).normalized();
        return curve.to_world.point(centre + across * half * side);
    };
    const auto place = [part = c.part](Random& random) {
        return random.uniform(part.begin(), part.end());
    };
    return {
        [=](const Vec3& from, Random& random) {
            return at(from, place(random), random.uniform(-0.5, 0.5));
        },
        [=](const Vec3& from, Random& random) {
            return at(from, place(random), random.sign() * nearly_one(finest, random));
        },
        [=](const Vec3& from, Random& random) {
            const double end = random.index(2) == 0 ? curve.part.begin() : curve.part.end();
            return at(from, end, random.uniform(-1, 1));
        },
    };
}

std::vector<Target> targets(const Outline& face) {
    std::vector<Target> list;
    for (const Feature feature : features) {
        list.emplace_back(
            [=](const Vec3&, Random& random) { return point_of(face, feature, random); });
    }
    return list;
}

/// Any target of any primitive of an instance's object, where the instance is.
Target target_on(const Geometry& geometry, const Instance& instance, double finest) {
    const Geometry& object = geometry.objects[instance.object];
    return [&object, instance, finest](const Vec3& from, Random& random) {
        const auto any = static_cast<std::uint32_t>(random.index(object.primitives.size()));
        const std::vector<Target> targets = targets_of(object, any, finest);
        const Target& target = targets[random.index(targets.size())];
        return instance.to_world().point(target(to_object(instance, from), random));
    };
}

}  // namespace

std::vector<Target> targets_of(const Geometry& geometry, std::uint32_t item, double finest,
                               ShutterTime time) {
    if (geometry.is_instance(item)) {
        const InstanceAt instance(geometry, geometry.instance_number(item), time);
        return {target_on(geometry, *instance, finest)};
    }
    const Primitive p = geometry.primitives[item];
    return with_shape(p.kind, [&]<class Shape>() {
        if constexpr (std::is_same_v<Shape, Triangle> || std::is_same_v<Shape, Polygon>) {
            return targets(Outline(geometry, item));
        } else {
            return targets(geometry.get<Shape>(p), finest);
        }
    });
}

Vec3 on_faces(const Box& box, int fixed, Random& random) {
    const int first = random.axis();
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
        const int k = (first + i) % 3;
        const double share = i < fixed ? static_cast<double>(random.index(2)) : random.uniform();
        p[k] = share == 1 ? box.max[k] : box.min[k] + share * (box.max[k] - box.min[k]);
    }
    return p;
}

}  // namespace etalon
