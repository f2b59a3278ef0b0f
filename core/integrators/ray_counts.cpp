#include "core/integrators/ray_counts.h"

namespace etalon {

RayCounts& RayCounts::operator+=(const RayCounts& other) {
    camera += other.camera;
    camera_hits += other.camera_hits;
    shadow += other.shadow;
    shadow_blocked += other.shadow_blocked;
    reflected += other.reflected;
    refracted += other.refracted;
    secondary_hits += other.secondary_hits;
    return *this;
}

}  // namespace etalon
