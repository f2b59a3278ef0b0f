// A ray's way through a grid (Amanatides & Woo 1987), with two differences that keep it exact: the
// distance to a plane is always recomputed from the plane's index, so that errors do not add up,
// and the walk ends by index, never by distance.
#pragma once

#include "core/intersect/frame.h"
#include "native_accel/grid/cells.h"

namespace etalon {

class GridWalk {
  public:
    /// tmin, tmax in the frame. The primitives' boxes are padded far beyond the roundings made
    /// here.
    GridWalk(const GridShape& shape, const Box3f& box, const FrameRay& ray, double tmin,
             double tmax)
        : shape_(shape), origin_(ray.origin), direction_(ray.direction) {
        double entry = tmin, exit = tmax;
        for (int k = 0; k < 3; ++k) {
            if (direction_[k] == 0) {
                if (origin_[k] < box.min[k] || origin_[k] > box.max[k]) exit = -infinity;
                continue;
            }
            const double a = (box.min[k] - origin_[k]) / direction_[k];
            const double b = (box.max[k] - origin_[k]) / direction_[k];
            entry = std::max(entry, std::min(a, b));
            exit = std::min(exit, std::max(a, b));
        }
        inside_ = entry <= exit;
        if (!inside_) return;
        for (int k = 0; k < 3; ++k) {
            cell_[k] = shape.cell(origin_[k] + entry * direction_[k], k);
            step_[k] = direction_[k] > 0 ? 1 : -1;
            find_crossing(k);
        }
    }

    bool inside() const { return inside_; }
    const CellIndex& cell() const { return cell_; }

    /// Where the ray leaves the current cell.
    double exit() const { return crossing_[next_axis()]; }

    void advance() {
        const int k = next_axis();
        cell_[k] += step_[k];
        inside_ = cell_[k] >= 0 && cell_[k] < shape_.resolution[k] && crossing_[k] < infinity;
        find_crossing(k);
    }

  private:
    int next_axis() const {
        const int xy = crossing_[0] <= crossing_[1] ? 0 : 1;
        return crossing_[xy] <= crossing_[2] ? xy : 2;
    }

    void find_crossing(int k) {
        const int plane = cell_[k] + (step_[k] > 0 ? 1 : 0);
        crossing_[k] =
            direction_[k] == 0 ? infinity : (shape_.plane(plane, k) - origin_[k]) / direction_[k];
    }

    const GridShape& shape_;
    Vec3 origin_, direction_;
    CellIndex cell_{}, step_{};
    std::array<double, 3> crossing_{};
    bool inside_ = false;
};

}  // namespace etalon
