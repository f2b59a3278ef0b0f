#pragma once

#include <array>
#include <string_view>

#include "core/numerics/local_frame.h"
#include "core/scene/convexity.h"

namespace etalon {

/// The profile of a surface of revolution, given by the surface's points: those with x^2 + y^2 =
/// squares[0] + squares[1] z + squares[2] z^2 and low <= z <= high. If v runs along a radius, they
/// are those of the plane z = 0 with low <= sqrt(x^2 + y^2) <= high.
struct Profile {
    /// Quantity in which the surface coordinate v is linear: the height; the angle from the axis,
    /// on the unit sphere; the radius, in the plane; or the position on a line from which the
    /// surface is swept, which is the sector's `from`.
    enum class Along { height, angle, radius, line };

    Along along = Along::height;
    std::array<double, 3> squares{};
    double low = 0, high = 0;
    bool falls = false;  ///< v is 0 at `high` and 1 at `low`

    bool is_flat() const { return along == Along::radius; }

    /// Returns the square of the radius at a height.
    double square(double z) const { return squares[0] + z * (squares[1] + z * squares[2]); }
};

/// A direction perpendicular to z that may change with the height: at + z * per_height, of any
/// length.
struct TurningDirection {
    Vec2 at{1, 0}, per_height{0, 0};

    Vec2 operator()(double z) const { return at + z * per_height; }
    bool turns() const { return per_height != Vec2(0); }
};

/// The part of a turn about z from one direction to another, both included. The surface coordinate
/// u grows along it from 0 to 1.
struct Sector {
    Sector() = default;

    /// Makes a sector of `degrees`, at most 360. Multiples of a quarter turn are exact.
    explicit Sector(double degrees, const TurningDirection& start = {});

    TurningDirection from, to;
    double angle = 0;       ///< radians
    bool is_whole = false;  ///< a whole turn
    bool is_convex = true;  ///< half a turn or less
};

/// The image under `to_world` of a part of a surface of revolution about z. The front is outside of
/// the curve, or above the plane.
///
/// The clipping heights, radii and directions belong to the surface. A line that lies in the
/// surface does not hit it.
struct Revolved {
    static constexpr std::string_view name = "revolved";
    static constexpr Convexity convexity = Convexity::any;

    Revolved(const Affine& map, const Profile& curve, const Sector& part);

    /// Returns the same surface under another map.
    Revolved under(const Affine& map) const { return {map, profile, sector}; }

    /// Returns whether there is a surface to hit: the map is not singular, and all is finite.
    bool exists() const;

    Affine to_world;
    LocalFrame frame;
    bool is_sheared;  ///< so strongly that roundings of local coordinates exceed those in world
    ///< space
    Profile profile;
    Sector sector;
};

}  // namespace etalon
