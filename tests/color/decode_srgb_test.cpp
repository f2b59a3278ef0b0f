#include "core/color/decode_srgb.h"

#include <bit>
#include <limits>
#include <vector>

#include "core/color/srgb.h"
#include "core/numerics/random.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

std::vector<float> values_to_decode() {
    using Limits = std::numeric_limits<float>;
    std::vector<float> values{0.0F,
                              -0.0F,
                              0.04045F,
                              std::nextafter(0.04045F, 1.0F),
                              1.0F,
                              -0.055F,
                              -1.0F,
                              Limits::denorm_min(),
                              Limits::max(),
                              -Limits::max(),
                              Limits::infinity(),
                              -Limits::infinity(),
                              Limits::quiet_NaN()};
    Random random(3);
    for (int i = 0; i < 50000; ++i) values.push_back(static_cast<float>(random.uniform(0, 1)));
    for (int i = 0; i < 1000; ++i) {
        values.push_back(static_cast<float>(std::exp2(random.uniform(-140, 128))));
        values.push_back(-values.back());
    }
    return values;
}

}  // namespace

TEST_CASE("Values decoded together are those decoded one by one", "[color]") {
    for_each_target([] {
        const std::vector<float> from = values_to_decode();
        for (const std::size_t count :
             {std::size_t{0}, std::size_t{1}, std::size_t{9}, from.size()}) {
            std::vector<float> values = from;
            decode_srgb(std::span(values).first(count));
            for (std::size_t i = 0; i < values.size(); ++i) {
                const auto alone = i < count ? static_cast<float>(srgb_decoded(from[i])) : from[i];
                CAPTURE(count, i, from[i]);
                // As bits: 0 and -0 are equal numbers.
                const int bits = std::bit_cast<int>(values[i]),
                          expected = std::bit_cast<int>(alone);
                if (bits != expected) CHECK(bits == expected);
            }
        }
    });
}
