#include "bench/speed/report/cells.h"
#include "bench/speed/report/speed_table.h"
#include "bench/speed/totals.h"

namespace etalon::speed {
namespace {

template <std::vector<double> Totals::*Ratios>
std::string mean_ratio(const Totals& totals) {
    return figure(geometric_mean(totals.*Ratios));
}

template <CheckedAnswers Totals::*Which>
std::string rays(const Totals& totals) {
    return count((totals.*Which).rays);
}

template <CheckedAnswers Totals::*Which>
std::string wrong(const Totals& totals) {
    return count((totals.*Which).wrong);
}

const table::Columns<Totals>& mean_columns() {
    static const table::Columns<Totals> all = {
        {"to", "builtin", 9, mean_ratio<&Totals::ratios>, meaning::builtin},
        {"to", "robust", 9, mean_ratio<&Totals::robust_ratios>, meaning::robust},
        {"sampled", "rays", 9, rays<&Totals::sampled>, meaning::sampled},
        {"sampled", "wrong", 9, wrong<&Totals::sampled>, meaning::wrong_of_sampled},
        {"disputed", "rays", 10, rays<&Totals::disputed>, meaning::disputed},
        {"disputed", "wrong", 10, wrong<&Totals::disputed>, meaning::wrong_of_disputed},
    };
    return all;
}

}  // namespace

std::string table_of_means(const SceneFigures& scene) {
    std::string text = table::heading(beginning("mean", ""), mean_columns(), Detail::narrow);
    for (const Totals& totals : totals_of({&scene, 1})) {
        text += table::line_of(beginning("mean", totals.tracer), totals, mean_columns(),
                               Detail::narrow);
    }
    return text;
}

void explain_means(table::Legend& legend) {
    legend.add("mean", "geometric means and sums over the kinds of rays, on one thread");
    table::explain(mean_columns(), Detail::narrow, legend);
}

}  // namespace etalon::speed
