#include "bench/accuracy/error_stats.h"

#include <algorithm>
#include <cmath>

namespace etalon::accuracy {

/// Bucket 0 is for zero; bucket b > 0 ends at 2^(b / steps - octaves / 2), inclusive.
void Distribution::add(double value) {
    const double place = (std::log2(value) + octaves / 2) * steps;
    const double last = octaves * steps;
    const double bucket = value > 0 ? std::clamp(std::ceil(place), 1.0, last) : 0;
    ++buckets_[static_cast<std::size_t>(bucket)];
    ++count_;
    max_ = std::max(max_, value);
}

Distribution& Distribution::operator+=(const Distribution& other) {
    for (std::size_t b = 0; b < buckets_.size(); ++b) buckets_[b] += other.buckets_[b];
    count_ += other.count_;
    max_ = std::max(max_, other.max_);
    return *this;
}

double Distribution::quantile(double q) const {
    const double wanted = q * static_cast<double>(count_);
    std::uint64_t passed = buckets_[0];
    std::size_t b = 0;
    while (static_cast<double>(passed) < wanted && b + 1 < buckets_.size()) passed += buckets_[++b];
    if (b == 0) return 0;
    return std::min(max_, std::exp2(static_cast<double>(b) / steps - octaves / 2));
}

ErrorStats& ErrorStats::operator+=(const ErrorStats& other) {
    for (const auto count :
         {&ErrorStats::rays, &ErrorStats::undecidable, &ErrorStats::false_hits,
          &ErrorStats::false_misses, &ErrorStats::wrong_roots, &ErrorStats::wrong_primitives,
          &ErrorStats::leaks, &ErrorStats::self_hits, &ErrorStats::contradictions,
          &ErrorStats::deviations}) {
        this->*count += other.*count;
    }
    for (const auto values :
         {&ErrorStats::float_ulps, &ErrorStats::double_ulps, &ErrorStats::conditioned,
          &ErrorStats::position, &ErrorStats::shift}) {
        this->*values += other.*values;
    }
    return *this;
}

}  // namespace etalon::accuracy
