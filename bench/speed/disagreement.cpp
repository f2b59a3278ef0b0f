#include "bench/speed/disagreement.h"

#include <bit>

namespace etalon::speed {
namespace {

bool is_hit(const Answer& a) {
    return a.primitive != no_index;
}

bool has_same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

Disagreement compare(std::span<const Answer> answers, std::span<const Answer> reference,
                     bool occlusion) {
    Disagreement d;
    d.rays = answers.size();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Answer &a = answers[i], &b = reference[i];
        if (is_hit(a) != is_hit(b)) {
            ++d.hit_or_miss;
        } else if (is_hit(a) && !occlusion) {
            if (a.primitive != b.primitive) {
                ++d.primitive;
            } else {
                d.distance += !has_same_bits(a.t, b.t);
            }
        }
    }
    return d;
}

}  // namespace etalon::speed
