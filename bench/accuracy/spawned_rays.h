// Rays that leave surfaces, and whether they hit what they left.
#pragma once

#include <optional>

#include "bench/accuracy/tracer.h"
#include "bench/hard_cases/hard_case.h"

namespace etalon::accuracy {

/// A ray that leaves the hit of another one in a random direction to either side. Half of them are
/// grazing: cosines down to 1e-6.
struct Spawned {
    Ray ray;
    HitKey from;   ///< primitive that it leaves
    bool outward;  ///< to the front
    double shift;  ///< distance of its origin from the hit, relative to the size
};

/// Returns a ray that leaves the hit of `ray`; nothing if that missed.
std::optional<Spawned> spawn(const hard::CaseSetup& setup, const Ray& ray, const Answer& answer,
                             Random& random);

/// Returns whether a spawned ray hit its own surface wrongly. No shape is hit by a ray that leaves
/// its front or, if it is flat, its back; a closed one is hit by a ray from its inside on its way
/// out.
bool is_self_hit(const Scene& scene, const Spawned& spawned, const Answer& answer);

}  // namespace etalon::accuracy
