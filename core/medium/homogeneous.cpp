#include "core/medium/homogeneous.h"

#include "core/medium/channels.h"

namespace etalon {
namespace {

/// Returns the probabilities of the channels: their fractions of the throughput.
Color channel_probabilities(const Color& throughput) {
    const float sum = throughput.x + throughput.y + throughput.z;
    return sum > 0 && std::isfinite(sum) ? throughput / sum : Color(1.0F / 3);
}

}  // namespace

FreeFlight sample_homogeneous(const PhysicalMedium& medium, const RaySegment& segment,
                              const Color& throughput, const Vec2& choices) {
    const Color extinction = medium.extinction();
    if (medium.scattering == Color(0.0F)) {
        return {infinity, transmittance(extinction, segment.length)};
    }
    const Color probabilities = channel_probabilities(throughput);
    const double along = extinction[chosen_channel(probabilities, choices.y)];
    const double distance = along > 0 ? optical_distance(choices.x) / along : infinity;
    const bool scatters = distance < segment.length;
    const Color left = transmittance(extinction, scatters ? distance : segment.length);
    const float density = probabilities.dot(scatters ? extinction * left : left);
    if (!(density > 0)) return {infinity, Color(0.0F)};
    if (!scatters) return {infinity, left / density};
    return {distance, medium.scattering * left / density, density};
}

float flight_density(const PhysicalMedium& medium, const Color& throughput, double distance) {
    const Color extinction = medium.extinction();
    return channel_probabilities(throughput).dot(extinction * transmittance(extinction, distance));
}

}  // namespace etalon
