#include "core/intersect/shapes/polygon.h"

#include "core/numerics/dyadic_vec.h"

namespace etalon {

PlanePassage exact_passage(std::span<const Vec3> p, const RayQuery& q) {
    const DyadicVec o = exactly(q.ray.origin), first = exactly(p[0]);
    DyadicVec previous = exactly(Vec3(0)), sum = first - o, normal = previous;
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
