#include "bench/statistics/statistics.h"

#include "bench/speed/alternate.h"
#include "bench/speed/figures.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::speed;
using statistics::quantile;

namespace {

RayFigures figures(const std::string& tracer, const std::vector<double>& cpu_seconds) {
    RayFigures f;
    f.tracer = tracer;
    f.by_threads = runs_on({1});
    for (const double s : cpu_seconds) f.by_threads[0].repeats.push_back({2 * s, s});
    return f;
}

}  // namespace

TEST_CASE("Quantiles are those of the sorted values, between neighbours by proportion") {
    const std::vector<double> values{4, 1, 3, 2, 5};
    CHECK(median(values) == 3);
    CHECK(quantile(values, 0.25) == 2);
    CHECK(quantile(values, 1) == 5);
    CHECK(median({1, 2}) == 1.5);
    CHECK(median({7}) == 7);
    CHECK(median({}) == 0);
    CHECK(estimate(values).spread == 2);
    CHECK_FALSE(estimate({7}).spread.has_value());
}

TEST_CASE("A geometric mean treats twice as fast and half as fast alike") {
    CHECK(geometric_mean({2, 0.5}) == Approx(1));
    CHECK(geometric_mean({3}) == Approx(3));
}

TEST_CASE("Repeats go forwards and backwards in turn") {
    std::vector<std::size_t> order;
    const auto note = [&](int, std::size_t k) { order.push_back(k); };
    CHECK(alternate(
              3, 3, [] { return false; }, note) == 3);
    CHECK(order == std::vector<std::size_t>{0, 1, 2, 2, 1, 0, 0, 1, 2});
    const auto is_over = [&] { return order.size() == 13; };
    CHECK(alternate(3, 3, is_over, note) == 1);  // of 9 + 4 calls
    CHECK(order.size() == 13);
}

TEST_CASE("A ratio is the median over repeats, which a slow spell of the machine leaves alone") {
    // The machine is ten times slower in the second repeat and five times in the third: medians of
    // either's seconds alone would give 4 and 10, and a ratio of 2.5.
    std::vector<RayFigures> all{figures("bvh", {1, 10, 4}), figures(baseline, {2, 20, 10}),
                                figures(robust_baseline, {3, 30, 12})};
    compare_with_baselines(all);
    const Runs& bvh = all[0].by_threads[0];
    CHECK(bvh.ratio.median == 2);
    CHECK(bvh.ratio.spread == 0.25);
    CHECK(bvh.ratio_robust.median == 3);
    CHECK(all[1].by_threads[0].ratio.median == 1);
    CHECK(all[2].by_threads[0].ratio_robust.median == 1);
}

TEST_CASE("More threads are compared with one thread of the same tracer") {
    std::vector<RayFigures> all{figures(baseline, {1}), figures(robust_baseline, {1})};
    for (RayFigures& f : all) {
        f.by_threads.push_back(f.by_threads[0]);
        f.by_threads[1].threads = 2;
        f.by_threads[1].repeats[0] = {1.25, 1.6};  // wall, CPU; alone: 2, 1
    }
    compare_with_baselines(all);
    CHECK(all[0].by_threads[0].cpu_scaling.median == 1);
    CHECK(all[0].by_threads[1].cpu_scaling.median == Approx(1 / 1.6));
    CHECK(all[0].by_threads[1].wall_scaling.median == Approx(2 / 1.25));
    CHECK(all[0].by_threads[1].ratio.median == 1);
}
