#include "bench/speed/disagreement.h"

#include <algorithm>

#include "core/numerics/same_bits.h"

namespace etalon::speed {
namespace {

bool is_hit(const Answer& a) {
    return a.primitive != no_index;
}

HitKey key_of(const Answer& a) {
    return etalon::key_of(a.primitive, a.instance);
}

/// Returns whether two answers to the same ray agree.
bool is_same(const Answer& a, const Answer& b, bool occlusion) {
    return occlusion ? is_hit(a) == is_hit(b) : key_of(a) == key_of(b);
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
            if (key_of(a) != key_of(b)) {
                ++d.primitive;
            } else {
                d.distance += !same_bits(a.t, b.t);
            }
        }
    }
    return d;
}

std::vector<std::size_t> disputed(const std::vector<std::vector<Answer>>& answers, bool occlusion) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < answers.front().size(); ++i) {
        const bool is_agreed = std::all_of(answers.begin(), answers.end(), [&](const auto& list) {
            return is_same(list[i], answers.front()[i], occlusion);
        });
        if (!is_agreed) places.push_back(i);
    }
    return places;
}

}  // namespace etalon::speed
