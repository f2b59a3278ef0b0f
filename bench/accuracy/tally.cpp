#include "bench/accuracy/tally.h"

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

Tally& Tally::operator+=(const Tally& other) {
    for (const auto count :
         {&Tally::rays, &Tally::undecidable, &Tally::false_hits, &Tally::false_misses,
          &Tally::wrong_roots, &Tally::wrong_primitives, &Tally::leaks, &Tally::self_hits,
          &Tally::contradictions, &Tally::deviations}) {
        this->*count += other.*count;
    }
    for (const auto values : {&Tally::float_ulps, &Tally::double_ulps, &Tally::conditioned,
                              &Tally::position, &Tally::shift}) {
        this->*values += other.*values;
    }
    return *this;
}

}  // namespace etalon::accuracy
