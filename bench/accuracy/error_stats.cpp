#include "bench/accuracy/error_stats.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace etalon::accuracy {

void Distribution::add(double value) {
    constexpr double last = steps * std::numeric_limits<double>::max_exponent;  // of infinities
    if (value > 0) {
        ++buckets_[static_cast<int>(std::min(std::ceil(std::log2(value) * steps), last))];
    } else {
        ++zeros_;
    }
    ++count_;
    max_ = std::max(max_, value);
}

Distribution& Distribution::operator+=(const Distribution& other) {
    for (const auto& [bucket, count] : other.buckets_) buckets_[bucket] += count;
    count_ += other.count_;
    zeros_ += other.zeros_;
    max_ = std::max(max_, other.max_);
    return *this;
}

double Distribution::quantile(double q) const {
    const double wanted = q * static_cast<double>(count_);
    std::uint64_t passed = zeros_;
    if (static_cast<double>(passed) >= wanted) return 0;
    for (const auto& [bucket, count] : buckets_) {
        passed += count;
        if (static_cast<double>(passed) >= wanted) {
            return std::min(max_, std::exp2(static_cast<double>(bucket) / steps));
        }
    }
    return max_;
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
