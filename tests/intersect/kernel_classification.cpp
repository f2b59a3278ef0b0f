#include "tests/intersect/kernel_classification.h"

#include "core/intersect/kernels.h"
#include "core/numerics/rounding.h"
#include "core/oracle/definitions.h"

namespace etalon {
namespace {

constexpr double fair_ulps = 4;

/// The hits of one kind, on the shape's front or on its back, of all rays of a neighbourhood.
struct Branch {
    bool in_some = false, in_all = true;
    double first = infinity, last = -infinity;

    void add(const Crossings& crossings, bool front) {
        bool certain = false;
        for (const Crossing& c : crossings) {
            const Certainty exists = c.exists & (front ? c.front : !c.front);
            if (exists == Certainty::no) continue;
            certain |= exists == Certainty::yes;
            in_some = true;
            const double t = static_cast<double>(c.t.value);
            first = std::min({first, t, static_cast<double>(c.passage.value)});
            last = std::max(last, t);
        }
        in_all &= certain;
    }

    void unite(const Branch& other) {
        in_some |= other.in_some;
        first = std::min(first, other.first);
        last = std::max(last, other.last);
    }
};

struct Branches {
    void add(const Geometry& geometry, const Ray& ray) {
        const Crossings found = crossings(geometry, 0, ray);
        front.add(found, true);
        back.add(found, false);
    }

    /// Joins front and back at tangents: if some rays of the neighbourhood miss the shape, one of
    /// them is a tangent, for which both coincide.
    void join_tangents() {
        if (front.in_some && !front.in_all && back.in_some && !back.in_all) join_sides();
    }

    /// Handles a surface seen edge-on, whose visible side is undecidable.
    void join_sides() {
        front.unite(back);
        back.unite(front);
        front.in_all = back.in_all = false;
    }

    void widen(double by) {
        for (Branch* branch : {&front, &back}) {
            branch->first -= by;
            branch->last += by;
        }
    }

    Branch front, back;
};

/// Returns the ray and `count` rays whose origin differs by up to `reach` along every axis, and the
/// direction by up to `turn`: the first twelve along one axis only, the others along all.
std::vector<Ray> neighbours(const Ray& ray, double reach, double turn, int count) {
    std::vector<Ray> rays(static_cast<std::size_t>(count + 1), ray);
    Random random(3);
    for (int i = 1; i <= count; ++i) {
        Ray& r = rays[static_cast<std::size_t>(i)];
        for (int k = 0; k < 6; ++k) {
            if (i <= 12 && k != (i - 1) / 2) continue;
            const double side = i <= 12 ? (i % 2 == 0 ? 1 : -1) : random.uniform(-1, 1);
            (k < 3 ? r.origin : r.direction)[k % 3] += side * (k < 3 ? reach : turn);
        }
    }
    return rays;
}

/// Returns whether t is possible for some ray of the neighbourhood.
bool contains(const Branches& branches, Sides sides, double tmin, double t) {
    const bool hit = t > tmin;
    bool explained = !hit;
    for (const auto& [branch, hidden] :
         {std::pair{branches.front, Sides::back}, std::pair{branches.back, Sides::front}}) {
        if (sides == hidden) continue;
        if (hit && branch.in_some && t >= branch.first && t <= branch.last) explained = true;
        const bool certain = branch.in_all && branch.first > tmin;
        if (certain && (!hit || branch.last < t)) return false;
    }
    return explained;
}

bool is_explained(const ShapeCase& shape, const Ray& ray, double t, double true_t, double roundings,
                  int count) {
    const double where = t > ray.tmin ? t : true_t;
    const double length = ray.direction.length();
    const double magnitude = (ray.origin - shape.centre).length() + shape.size +
                             max_abs(ray.origin) + max_abs(shape.centre) + where * length;
    const double reach = roundings * unit_roundoff * magnitude;
    const double turn = roundings * unit_roundoff * length;
    Branches branches;
    for (const Ray& r : neighbours(ray, reach, turn, shape.exact ? 0 : count)) {
        branches.add(shape.scene.geometry, r);
    }
    branches.join_tangents();
    // t moves by this much when the surface moves by `reach`.
    const SurfacePoint point = surface_at(shape.scene.geometry, ray, {where, 0});
    const double cosine = std::abs(point.normal.dot(ray.direction));
    if (cosine <= turn) branches.join_sides();
    const Primitive primitive = shape.scene.geometry.primitives[0];
    // A quadric's position may be less certain than its lengths suggest, since the terms of its
    // form cancel.
    const bool cancels = primitive.kind == kind_of<Quadric>();
    const double uncertainty = cancels ? std::max(reach, max_abs(point.error) / 4) : reach;
    branches.widen(uncertainty / cosine + fair_ulps * 2 * unit_roundoff * where);
    return contains(branches, primitive.sides, ray.tmin, t);
}

}  // namespace

double ulps_off(const OracleAnswer& answer, double t) {
    const double ulp = std::nextafter(std::abs(answer.t), infinity) - std::abs(answer.t);
    return answer.relative_error(t) * std::abs(answer.t) / ulp;
}

Classification classify(const ShapeCase& shape, const Oracle& oracle, const Ray& ray, double t,
                        double roundings) {
    const OracleAnswer answer = oracle.closest(ray);
    if (answer.kind == OracleAnswer::undecidable) return Classification::undecidable;
    const bool hit = t > ray.tmin;
    const bool truly_hit = answer.kind == OracleAnswer::hit;
    if (hit == truly_hit && (!hit || ulps_off(answer, t) <= fair_ulps))
        return Classification::right;

    if (is_explained(shape, ray, t, truly_hit ? answer.t : 0, roundings, 12)) {
        return Classification::nearly_right;
    }
    const bool explained = is_explained(shape, ray, t, truly_hit ? answer.t : 0, roundings, 200);
    return explained ? Classification::nearly_right : Classification::wrong;
}

}  // namespace etalon
