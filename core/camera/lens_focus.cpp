#include "core/camera/lens_focus.h"

#include <cmath>

#include "core/camera/lens_tracer.h"

namespace etalon {
namespace {

/// Points at which a lens refracts a ray parallel to its axis, and at which that ray meets the
/// axis.
struct CardinalPoints {
    double principal, focal;
};

CardinalPoints cardinal_points(const LensRay& in, const LensRay& out) {
    const auto z_at = [&](double x) {
        return out.origin.z + (x - out.origin.x) / out.direction.x * out.direction.z;
    };
    return {z_at(in.origin.x), z_at(0)};
}

}  // namespace

Result<LensFocus> focused(const LensSystem& lens, double distance) {
    const LensTracer tracer(lens.surfaces);
    const double height = 1e-3 * lens.film_diagonal;
    const LensRay from_scene{{height, 0, tracer.front_z() + 1}, {0, 0, -1}};
    const LensRay from_film{{height, 0, tracer.rear_z() - 1}, {0, 0, 1}};
    const auto to_film = tracer.from_scene(from_scene), to_scene = tracer.from_film(from_film);
    if (!to_film || !to_scene) return {{}, "no light passes along its axis"};
    const CardinalPoints rear = cardinal_points(from_scene, *to_film),
                         front = cardinal_points(from_film, *to_scene);
    // With distances along the axis: object and image of a thick lens are at z and z' from its
    // principal planes where 1 / z' - 1 / z = 1 / f. The lens moves by `shift`, the film does not.
    const double f = rear.principal - rear.focal;
    const double between = distance - front.principal + rear.principal;
    const double square = between * (between - 4 * f);
    if (!(square > 0)) return {{}, "it cannot be focused so near"};
    const double shift = (distance - front.principal - rear.principal - std::sqrt(square)) / 2;
    const double film_distance = lens.surfaces.back().thickness + shift;
    if (!(film_distance > 0) || !std::isfinite(film_distance))
        return {{}, "it does not gather light"};
    return {{film_distance, rear.principal + shift}, {}};
}

}  // namespace etalon
