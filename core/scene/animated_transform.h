#pragma once

#include <array>

#include "core/numerics/quaternion.h"
#include "core/scene/shutter.h"

namespace etalon {

/// A map that changes with time. Between two maps, taken apart into a translation after a rotation
/// after a stretch, the translation and the stretch change linearly and the rotation at constant
/// speed by the shorter way; before and after them nothing moves. That is what pbrt-v3 does, except
/// that the rotation of a map that mirrors is a rotation here.
class AnimatedTransform {
  public:
    AnimatedTransform(const Affine& start, const Affine& end, const MotionTimes& times);

    /// Returns the map that rays of a time see. Not finite in between where one of the two maps is
    /// singular.
    Affine at(ShutterTime time) const { return at_part(times_.part(time)); }

    /// Returns the map where a part of the motion is done, in [0, 1].
    Affine at_part(double part) const;

    /// Returns whether the maps differ by where the origin goes alone.
    bool is_translation() const;

    /// Returns where the origin is.
    Vec3 origin_at(ShutterTime time) const { return origin_at_part(times_.part(time)); }

    const MotionTimes& times() const { return times_; }

    /// Returns a bound on how far a point of `box` leaves, while a part `length` of the motion is
    /// done, the straight way between the places where it begins and ends that.
    double deviation(const Box3& box, double length) const;

    /// Returns a bound on how much the stretch changes while a part `length` of the motion is done:
    /// the root of the sum of the squares of its nine numbers' changes.
    double stretch_change(double length) const;

    /// Returns the motion of what is made larger and then moved.
    AnimatedTransform after(double factor, const Vec3& offset) const;

  private:
    Vec3 origin_at_part(double part) const;
    Affine rotation_at_part(double part) const;

    MotionTimes times_;
    Affine start_, end_;
    Quaternion from_, to_;  ///< the rotations, of which the second is on the first one's side
    Quaternion across_;     ///< unit quaternion of their plane, at right angles to the first
    double angle_;          ///< between the quaternions: half that of the rotation
    std::array<Affine, 2> stretches_;
};

}  // namespace etalon
