#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace etalon {

/// Range of samples of each pixel. For a pixel with a rate, numbers are multiplied by the rate.
struct SampleShare {
    std::uint64_t seed;
    std::uint32_t first, end;
    bool may_have_rates = false;  ///< the image has so many samples that pixels may have rates

    auto operator<=>(const SampleShare&) const = default;
};

/// Sorts shares, and joins those that continue each other.
void join_shares(std::vector<SampleShare>& shares);

}  // namespace etalon
