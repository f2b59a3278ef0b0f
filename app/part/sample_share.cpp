#include "app/part/sample_share.h"

#include <algorithm>

namespace etalon {

void join_shares(std::vector<SampleShare>& shares) {
    std::ranges::sort(shares);
    std::vector<SampleShare> joined;
    for (const SampleShare& s : shares) {
        const auto continues = [&](const SampleShare& last) {
            return last.seed == s.seed && last.end == s.first &&
                   last.may_have_rates == s.may_have_rates;
        };
        if (!joined.empty() && continues(joined.back())) {
            joined.back().end = s.end;
        } else {
            joined.push_back(s);
        }
    }
    shares = std::move(joined);
}

}  // namespace etalon
