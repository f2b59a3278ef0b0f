#pragma once

#include <array>
#include <string_view>

#include "core/numerics/local_frame.h"
#include "core/scene/convexity.h"

namespace etalon {

/// The curve that a surface of revolution is swept from, as all points of the surface: those with
/// x^2 + y^2 = squares[0] + squares[1] z + squares[2] z^2 and low <= z <= high; or, where v goes
/// along a radius, those of the plane z = 0 with low <= sqrt(x^2 + y^2) <= high.
struct Profile {
    /// What the surface coordinate v is linear in: the height; the angle from the axis, on the unit
    /// sphere; the radius, in the plane; or the place on a line that the surface is swept from,
    /// which is the sector's `from`.
    enum class Along { height, angle, radius, line };

    Along along = Along::height;
    std::array<double, 3> squares{};
    double low = 0, high = 0;
    bool falls = false;  ///< v is 0 at `high` and 1 at `low`

    bool is_flat() const { return along == Along::radius; }

    /// The square of the radius at a height.
    double square(double z) const { return squares[0] + z * (squares[1] + z * squares[2]); }
};

/// A direction across z that may change with the height: at + z * per_height, of any length.
struct TurningDirection {
    Vec2 at{1, 0}, per_height{0, 0};

    Vec2 operator()(double z) const { return at + z * per_height; }
    bool turns() const { return per_height != Vec2(0); }
};

/// The part of a turn about z from one direction to another, both of which belong to it; the
/// surface coordinate u grows along it from 0 to 1.
struct Sector {
    Sector() = default;

    /// Of so many degrees, at most 360. Quarters of a turn are exact.
    explicit Sector(double degrees, const TurningDirection& start = {});

    TurningDirection from, to;
    double angle = 0;       ///< radians
    bool is_whole = false;  ///< nothing is cut off
    bool is_convex = true;  ///< half a turn or less
};

/// The image of a part of a surface of revolution about z under `to_world`. The front is outside
/// of the curve, or above the plane.
///
/// The clipping heights, radii and directions belong to the surface. A line all of whose points are
/// on the surface meets it nowhere.
struct Revolved {
    static constexpr std::string_view name = "revolved";
    static constexpr Convexity convexity = Convexity::any;

    Revolved(const Affine& map, const Profile& curve, const Sector& part);

    /// The same surface in another place.
    Revolved under(const Affine& map) const { return {map, profile, sector}; }

    /// Returns whether there is something to be met: the map is not singular, and all is finite.
    bool exists() const;

    Affine to_world;
    LocalFrame frame;
    bool is_sheared;  ///< so far that a rounding of local coordinates is more than one of the
                      ///< world's
    Profile profile;
    Sector sector;
};

}  // namespace etalon
