#include "core/intersect/outliers.h"

#include <bit>
#include <cmath>

#include "core/intersect/normalized_space.h"

namespace etalon {
namespace {

/// Difference of the exponents of the reach of items and that of all others, at which they are
/// outliers whatever that costs. At this factor the padding of boxes is a thirtieth of the reach of
/// the others.
constexpr std::uint64_t far_beyond = 14;

/// Time to test a primitive or an instance, as fractions of the time that a ray takes in an
/// accelerator. Measured with a triangle below a mesh: .07.
constexpr double cost_of_primitive = 1.0 / 8, cost_of_instance = 1;

/// The estimated gain above which a few items are outliers; so that what is estimated wrongly by
/// less makes no scene slower.
constexpr double least_gain = 1.25;

/// Returns the biased exponent of a number that is not negative.
std::uint64_t binade_of(double x) {
    return std::bit_cast<std::uint64_t>(x) >> 52;
}

}  // namespace

ReachCounts::Count& ReachCounts::Count::operator+=(const Count& more) {
    primitives += more.primitives;
    instances += more.instances;
    binades += more.binades;
    return *this;
}

ReachCounts::Count& ReachCounts::Count::operator-=(const Count& fewer) {
    primitives -= fewer.primitives;
    instances -= fewer.instances;
    binades -= fewer.binades;
    return *this;
}

void ReachCounts::add(double reach, double size, bool is_instance) {
    if (!(reach > 0)) return;
    if (is_instance) {
        add(binade_of(reach), {0, 1, 0});
    } else {
        add(binade_of(reach), {1, 0, binade_of(size)});
    }
}

void ReachCounts::add(const ReachCounts& others) {
    for (const auto& [binade, count] : others.counts_) add(binade, count);
}

void ReachCounts::add(std::uint64_t binade, const Count& count) {
    auto at = counts_.begin();
    while (at != counts_.end() && at->first > binade) ++at;
    if (at == counts_.end() || at->first != binade) at = counts_.insert(at, {binade, {}});
    at->second += count;
}

/// Most items are never outliers: their tree is slower than normalized space.
double ReachCounts::limit(OutlierRule rule) const {
    Count near, far;
    for (const auto& [binade, count] : counts_) near += count;
    double limit = infinity;
    double least = counts_.empty() ? 0 : cost(far, near, counts_.front().first) / least_gain;
    for (std::size_t i = 0; i + 1 < counts_.size(); ++i) {
        const auto& [binade, count] = counts_[i];
        const std::uint64_t next = counts_[i + 1].first;
        far += count;
        near -= count;
        const double with_outliers = cost(far, near, next);
        if (far.all() > near.all()) break;
        const bool is_better =
            rule == OutlierRule::cost && far.all() <= few && with_outliers < least;
        if (!is_better && !leave_no_room(far, binade - next)) continue;
        limit = std::nextafter(std::bit_cast<double>((next + 1) << 52), 0.0);
        least = std::min(least, with_outliers);
    }
    return limit;
}

/// Returns whether items that reach beyond the others by so many binades are outliers in any case:
/// not many instances, which have no tree of their own.
bool ReachCounts::leave_no_room(const Count& far, std::uint64_t binades_between) {
    return binades_between > far_beyond && (far.all() <= few || far.instances <= few);
}

/// Returns the estimated time of a ray, relative to that without outliers if boxes had no padding:
/// the padding makes those of primitives, which have as many different sizes as there are, larger
/// in two directions. The boxes of instances are finer (see least_padding).
double ReachCounts::cost(const Count& far, const Count& near, std::uint64_t binade_of_near) {
    const double of_outliers = cost_of_primitive * static_cast<double>(far.primitives) +
                               cost_of_instance * static_cast<double>(far.instances);
    if (near.primitives == 0) return of_outliers + 1;
    const double mean_binade =
        static_cast<double>(near.binades) / static_cast<double>(near.primitives);
    const double end_of_near = static_cast<double>(binade_of_near) + 1;
    const double growth = 1 + 2 * NormalizedSpace::padding * std::exp2(end_of_near - mean_binade);
    return of_outliers + growth * growth;
}

}  // namespace etalon
