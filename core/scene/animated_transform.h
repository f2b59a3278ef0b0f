#pragma once

#include <array>

#include "core/numerics/quaternion.h"
#include "core/scene/shutter.h"

namespace etalon {

/// An affine map that changes with time, between two keyframes. Each keyframe is decomposed into a
/// stretch, then a rotation, then a translation. Translation and stretch are interpolated linearly,
/// the rotation at constant angular speed by the shorter way; before and after the keyframes
/// nothing moves. pbrt-v3 does the same, except that the rotation of a mirroring map is a rotation
/// here.
class AnimatedTransform {
  public:
    AnimatedTransform(const Affine& start, const Affine& end, const MotionTimes& times);

    /// Returns the map at the time of a ray. Between the keyframes it is not finite if one of them
    /// is singular.
    Affine at(ShutterTime time) const { return at_part(times_.part(time)); }

    /// Returns the map at a fraction of the motion, in [0, 1].
    Affine at_part(double part) const;

    /// Returns whether the keyframes differ only in their translations.
    bool is_translation() const;

    /// Returns the position of the origin.
    Vec3 origin_at(ShutterTime time) const { return origin_at_part(times_.part(time)); }

    const MotionTimes& times() const { return times_; }

    /// Returns a bound on how far a point of `box` departs from a straight line during a fraction
    /// `length` of the motion.
    double deviation(const Box3& box, double length) const;

    /// Returns a bound on the change of the stretch during a fraction `length` of the motion: the
    /// root of the sum of the squares of its nine numbers' changes.
    double stretch_change(double length) const;

    /// Returns the motion of an object that is scaled by `factor` and then moved by `offset`.
    AnimatedTransform after(double factor, const Vec3& offset) const;

  private:
    Vec3 origin_at_part(double part) const;
    Affine rotation_at_part(double part) const;

    MotionTimes times_;
    Affine start_, end_;
    Quaternion from_, to_;  ///< the rotations; the second is in the first one's hemisphere
    Quaternion across_;     ///< unit quaternion in their plane, orthogonal to the first
    double angle_;          ///< between the quaternions: half that of the rotation
    std::array<Affine, 2> stretches_;
};

}  // namespace etalon
