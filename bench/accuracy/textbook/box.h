#pragma once

#include "bench/accuracy/textbook/kernel.h"

namespace etalon::accuracy {

/// Slab test by the smaller and the larger of each pair (Kay & Kajiya 1986, SIGGRAPH '86), with the
/// precomputed reciprocals of a ray.
struct TextbookBox {
    using RayForm = PreparedRay;

    explicit TextbookBox(const Box& b) : min(b.min), max(b.max) {}

    float first_hit(const PreparedRay& ray) const {
        float entry = -std::numeric_limits<float>::infinity(), exit = -entry;
        for (int k = 0; k < 3; ++k) {
            const float low = (min[k] - ray.origin[k]) * ray.inverse[k];
            const float high = (max[k] - ray.origin[k]) * ray.inverse[k];
            entry = std::max(entry, std::min(low, high));
            exit = std::min(exit, std::max(low, high));
        }
        return entry <= exit ? first_within(ray, entry, exit) : no_root<float>;
    }

    Vec3f min, max;
};

/// Bounds selected by the sign of the direction, comparisons that ignore a NaN, and the exit
/// increased by two ulp, so that rounding cannot lose a hit (Ize 2013, JCGT 2(2)).
struct PaddedBox {
    using RayForm = PreparedRay;

    explicit PaddedBox(const Box& b) : bounds{Vec3f(b.min), Vec3f(b.max)} {}

    float first_hit(const PreparedRay& ray) const {
        float entry = -std::numeric_limits<float>::infinity(), exit = -entry;
        for (int k = 0; k < 3; ++k) {
            const bool backwards = std::signbit(ray.inverse[k]);
            const float near = (bounds[backwards][k] - ray.origin[k]) * ray.inverse[k];
            const float far = (bounds[!backwards][k] - ray.origin[k]) * ray.inverse[k];
            if (near > entry) entry = near;
            if (far < exit) exit = far;
        }
        return entry <= exit * 1.00000024F ? first_within(ray, entry, exit) : no_root<float>;
    }

    Vec3f bounds[2];
};

/// The same slabs in double, each bound divided by the direction: a quotient is rounded once less
/// than a product with a reciprocal.
struct DoubleBox {
    using RayForm = Ray;

    explicit DoubleBox(const Box& b) : min(b.min), max(b.max) {}

    double first_hit(const Ray& ray) const {
        double entry = -infinity, exit = infinity;
        for (int k = 0; k < 3; ++k) {
            const double low = (min[k] - ray.origin[k]) / ray.direction[k];
            const double high = (max[k] - ray.origin[k]) / ray.direction[k];
            entry = std::max(entry, std::min(low, high));
            exit = std::min(exit, std::max(low, high));
        }
        return entry <= exit ? first_within(ray, entry, exit) : no_root<double>;
    }

    Vec3 min, max;
};

inline auto textbook_kernels(const Scene&, const Box& b) {
    return std::tuple{Named{"float min/max slabs", TextbookBox(b)},
                      Named{"float Ize", PaddedBox(b)}, Named{"double slabs", DoubleBox(b)}};
}

}  // namespace etalon::accuracy
