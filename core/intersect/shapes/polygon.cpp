#include "core/intersect/shapes/polygon.h"

#include "core/numerics/dyadic.h"

namespace etalon {
namespace {

using DyadicVec = std::array<Dyadic, 3>;

DyadicVec exactly(const Vec3& v) {
    return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)};
}

DyadicVec operator+(const DyadicVec& a, const DyadicVec& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

DyadicVec operator-(const DyadicVec& a, const DyadicVec& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

DyadicVec cross(const DyadicVec& a, const DyadicVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Dyadic dot(const DyadicVec& a, const DyadicVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

PlanePassage exact_passage(std::span<const Vec3> p, const RayQuery& q) {
    const DyadicVec o = exactly(q.ray.origin), first = exactly(p[0]);
    DyadicVec previous = first - first, sum = first - o, normal = previous;
    for (const Vec3& corner : p.subspan(1)) {
        const DyadicVec c = exactly(corner), next = c - first;
        normal = normal + cross(previous, next);
        sum = sum + (c - o);
        previous = next;
    }
    const Dyadic cosine = dot(normal, exactly(q.ray.direction));
    const Dyadic distance = dot(normal, sum);
    if (cosine.sign() == 0) return {no_hit, 0};
    const WideDouble count = Dyadic(static_cast<double>(p.size())).magnitude();
    const WideDouble t = distance.magnitude() / cosine.magnitude() / count;
    return {distance.sign() * cosine.sign() * static_cast<double>(t),
            static_cast<double>(cosine.sign())};
}

}  // namespace etalon
