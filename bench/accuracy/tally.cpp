#include "bench/accuracy/tally.h"

#include <algorithm>
#include <cmath>

namespace etalon::accuracy {
namespace {

constexpr double least_exponent = -64;

}  // namespace

void Distribution::add(double value) {
    const double place = (std::log2(value) - least_exponent) * steps;
    const double last = octaves * steps;
    ++buckets_[value > 0 ? static_cast<std::size_t>(std::clamp(place + 1, 0.0, last)) : 0];
    ++count_;
    max_ = std::max(max_, value);
}

Distribution& Distribution::operator+=(const Distribution& other) {
    for (std::size_t i = 0; i < buckets_.size(); ++i) buckets_[i] += other.buckets_[i];
    count_ += other.count_;
    max_ = std::max(max_, other.max_);
    return *this;
}

double Distribution::quantile(double q) const {
    const double wanted = q * static_cast<double>(count_);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < buckets_.size(); ++i) {
        seen += buckets_[i];
        if (seen == 0 || static_cast<double>(seen) < wanted) continue;
        if (i == 0) return 0;
        const double top = std::exp2(static_cast<double>(i) / steps + least_exponent);
        return std::min(top, max_);
    }
    return max_;
}

Tally& Tally::operator+=(const Tally& other) {
    rays += other.rays;
    undecidable += other.undecidable;
    false_hits += other.false_hits;
    false_misses += other.false_misses;
    wrong_roots += other.wrong_roots;
    wrong_primitives += other.wrong_primitives;
    leaks += other.leaks;
    self_hits += other.self_hits;
    contradictions += other.contradictions;
    deviations += other.deviations;
    float_ulps += other.float_ulps;
    double_ulps += other.double_ulps;
    conditioned += other.conditioned;
    position += other.position;
    shift += other.shift;
    return *this;
}

}  // namespace etalon::accuracy
