#include "bench/accuracy/report/remarks.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/numbers.h"

namespace etalon::accuracy {
namespace {

/// Largest error of t, in ulp of a float, that needs no remark.
constexpr double usual_error = 1;

/// Largest error of t of a backward stable algorithm, relative to the change of t by one roundoff
/// in each input.
constexpr double usual_condition = 4;

void add_partial(const std::vector<CaseRows>& measured, std::size_t cases,
                 std::vector<std::string>& remarks) {
    const auto cut =
        std::ranges::count_if(measured, [](const CaseRows& c) { return c.fullest().partial; });
    if (cut == 0 && measured.size() >= cases) return;
    remarks.push_back(
        fmt::format("Partial: {} of {} cases were measured, {} of them with fewer "
                    "rays than asked for.",
                    measured.size(), cases, cut));
}

/// Returns the case in which an exact tracer's error of t is largest.
const Row* worst_exact(const std::vector<CaseRows>& cases) {
    const Row* worst = nullptr;
    for (const CaseRows& c : cases) {
        for (const Row* row : c.rows) {
            if (!row->exact) continue;
            const double error = row->stats.float_ulps.max();
            if (worst == nullptr || error > worst->stats.float_ulps.max()) worst = row;
        }
    }
    return worst;
}

void add_condition(const std::vector<CaseRows>& cases, std::vector<std::string>& remarks) {
    const Row* row = worst_exact(cases);
    if (row == nullptr || row->stats.float_ulps.max() <= usual_error) return;
    const double condition = row->stats.conditioned.max();
    remarks.push_back(fmt::format(
        "The {} ulp of tracers that promise to be right are in {}, {} ({} wrong answers): at most "
        "{} times what one roundoff in each input does to t, {}.",
        brief(row->stats.float_ulps.max()), row->id, row->variant, row->stats.errors(),
        brief(condition),
        condition <= usual_condition ? "whose last bits the input does not decide there"
                                     : "which is more than the rounding of the input explains"));
}

}  // namespace

std::vector<std::string> remarks_on(const std::vector<Row>& rows, const std::string& shape,
                                    std::size_t cases) {
    const std::vector<CaseRows> measured = cases_of(rows, shape);
    std::vector<std::string> remarks;
    add_partial(measured, cases, remarks);
    add_condition(measured, remarks);
    return remarks;
}

}  // namespace etalon::accuracy
