#include "core/medium/media.h"

#include "core/medium/homogeneous.h"

namespace etalon {

Media::Media(const std::vector<PhysicalMedium>& media) : media_(media) {
    for (const PhysicalMedium& medium : media) {
        phases_.emplace_back(medium.g);
        grids_.emplace_back();
        if (medium.grid) grids_.back().emplace(medium);
    }
}

FreeFlight Media::sample(std::uint32_t medium, const RaySegment& segment, const Color& throughput,
                         FlightChoices choices) const {
    if (const auto& grid = grids_[medium]) {
        return grid->sample(segment, throughput, choices.first.x, choices.numbers);
    }
    return sample_homogeneous(media_[medium], segment, throughput, choices.first);
}

Color Media::transmittance(std::uint32_t medium, const RaySegment& segment,
                           RandomSequence& numbers) const {
    if (const auto& grid = grids_[medium]) return grid->transmittance(segment, numbers);
    return etalon::transmittance(media_[medium].extinction(), segment.length);
}

}  // namespace etalon
