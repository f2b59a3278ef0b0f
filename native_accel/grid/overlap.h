// What is put into grids, and which cells it really crosses: a shape can be far smaller than its
// box.
#pragma once

#include <array>
#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Something of which only a box is known. All in the accelerator's frame.
struct BoxItem {
    Box3f box;
    std::uint32_t id;  ///< number in Scene::primitives
};

struct SphereItem {
    Box3f box;
    std::uint32_t id;
    Vec3 centre;
    double radius;
};

struct TriangleItem {
    Box3f box;
    std::uint32_t id;
    std::array<Vec3f, 3> corners;
};

/// touches(): whether what an item is has a point in common with a box of the given centre and
/// half_size size, or might have. False only of what is apart by more than the roundings of
/// doubles.
template <class Item>
class Overlap;

template <>
class Overlap<BoxItem> {
  public:
    Overlap(const BoxItem&, const Vec3&) {}
    bool touches(const Vec3&) const { return true; }
};

template <>
class Overlap<SphereItem> {
  public:
    Overlap(const SphereItem& item, const Vec3& half_size)
        : centre_(item.centre), half_(half_size), radius2_(item.radius * item.radius) {}

    bool touches(const Vec3& centre) const {
        double distance2 = 0;
        for (int k = 0; k < 3; ++k) {
            const double d = std::max(std::abs(centre[k] - centre_[k]) - half_[k], 0.0);
            distance2 += d * d;
        }
        return distance2 <= radius2_;
    }

  private:
    Vec3 centre_, half_;
    double radius2_;
};

/// Separating axes as half planes whose parts that belong to the box's size are worked out once
/// (Schwarz & Seidel 2010, "Fast Parallel Surface and Solid Voxelization on GPUs"): the triangle's
/// plane, and its edges as seen along each axis. The axes themselves, which are the triangle's box,
/// are left out.
template <>
class Overlap<TriangleItem> {
  public:
    Overlap(const TriangleItem& item, const Vec3& half_size) {
        const std::array<Vec3, 3> p = {Vec3(item.corners[0]), Vec3(item.corners[1]),
                                       Vec3(item.corners[2])};
        normal_ = (p[1] - p[0]).cross(p[2] - p[0]);
        offset_ = normal_.dot(p[0]);
        reach_ = abs(normal_).dot(half_size);
        for (int i = 0; i < 3; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                sides_[3 * i + axis] = Side(p[i], p[(i + 1) % 3], p[(i + 2) % 3], axis, half_size);
            }
        }
    }

    bool touches(const Vec3& centre) const {
        if (std::abs(normal_.dot(centre) - offset_) > reach_) return false;
        for (int i = 0; i < 9; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            if (sides_[i].a * centre[j] + sides_[i].b * centre[k] + sides_[i].c < 0) return false;
        }
        return true;
    }

  private:
    /// a y + b z + c >= 0 where a box at (y, z) reaches over an edge, seen along x.
    struct Side {
        Side() = default;
        Side(const Vec3& from, const Vec3& to, const Vec3& other, int axis, const Vec3& half_size) {
            const int j = (axis + 1) % 3, k = (axis + 2) % 3;
            a = from[k] - to[k];
            b = to[j] - from[j];
            if (a * (other[j] - from[j]) + b * (other[k] - from[k]) < 0) a = -a, b = -b;
            c = std::abs(a) * half_size[j] + std::abs(b) * half_size[k] - a * from[j] - b * from[k];
        }
        double a = 0, b = 0, c = 0;
    };

    Vec3 normal_;
    double offset_, reach_;
    std::array<Side, 9> sides_;
};

}  // namespace etalon
