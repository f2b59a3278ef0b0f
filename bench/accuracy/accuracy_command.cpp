// etalon-bench accuracy: compares tracers with the oracle on the hard cases, with millions of rays.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/output.h"
#include "app/common/signals.h"
#include "bench/accuracy/measure_case.h"
#include "bench/accuracy/report/accuracy_json.h"
#include "bench/accuracy/report/accuracy_table.h"
#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/markdown.h"
#include "bench/accuracy/report/plot.h"
#include "bench/accuracy/report/remarks.h"
#include "bench/bench_subcommands.h"
#include "bench/hard_cases/case_names.h"
#include "core/render/deadline.h"

namespace etalon {
namespace {

using accuracy::Row;
using hard::HardCase;
using Json = nlohmann::ordered_json;

struct AccuracyArguments {
    std::vector<std::string> cases;
    std::vector<std::string> backends = backend_names();
    double rays = 100'000;
    double seconds = infinity;
    bool only_backends = false, list = false, wide = false;
    std::string json, markdown, plots;

    table::Detail detail() const { return wide ? table::Detail::wide : table::Detail::narrow; }
};

int list_cases(const std::vector<HardCase>& cases) {
    std::string text;
    for (const HardCase& c : cases) text += fmt::format("{}/{}\n", c.id, c.variant);
    write_result(text);
    return exit_done;
}

/// Returns whether a backend or kernel that is exact had an error.
bool is_broken_promise(const Row& row) {
    return row.exact && row.stats.errors() > 0;
}

const std::string partial = "Stopped by a signal: not all cases and rays.\n",
                  unfinished = "Unfinished: not all cases.\n";

/// Writes a plot with remarks for each shape that was measured.
bool write_plots(const std::string& folder, const std::vector<HardCase>& cases,
                 const std::vector<Row>& rows) {
    bool written = true;
    for (const std::string& shape : accuracy::shapes_of(rows)) {
        const auto wanted = std::ranges::count(cases, shape, &HardCase::shape);
        const std::string svg = accuracy::plot(
            rows, shape, accuracy::remarks_on(rows, shape, static_cast<std::size_t>(wanted)));
        if (!svg.empty()) written &= write_text(folder + '/' + shape + ".svg", svg);
    }
    return written;
}

/// Writes the files; `stopped` is "signal" or "error" if rows are missing, or null.
bool write_reports(const AccuracyArguments& a, const std::vector<HardCase>& cases,
                   const std::vector<Row>& rows, const Json& stopped) {
    bool written = true;
    if (!a.json.empty()) {
        Json json = accuracy::json(rows);
        json["stopped"] = stopped;
        written &= write_json(a.json, json);
    }
    if (!a.markdown.empty()) {
        const std::string mark =
            stopped.is_null() ? "" : (stopped == "signal" ? partial : unfinished) + "\n";
        written &= write_text(a.markdown, mark + accuracy::markdown(rows));
    }
    return (a.plots.empty() || write_plots(a.plots, cases, rows)) && written;
}

/// Writes the rows so far after the first case and then now and then, since all cases take hours.
class Keeper {
  public:
    Keeper(AccuracyArguments a, const std::vector<HardCase>& cases)
        : arguments_(std::move(a)), cases_(cases) {
        for (std::string* path : {&arguments_.json, &arguments_.markdown}) {
            if (!is_replaceable(*path)) path->clear();
        }
    }

    void keep(const std::vector<Row>& rows) {
        if (pause_.is_limited() && !pause_.is_over()) return;
        write_reports(arguments_, cases_, rows, "error");
        pause_ = Deadline(seconds);
    }

  private:
    static constexpr double seconds = 10;
    AccuracyArguments arguments_;  ///< without what cannot be replaced
    const std::vector<HardCase>& cases_;
    Deadline pause_;
};

/// Measures rows until a stop; the case that was interrupted may have fewer rays.
std::vector<Row> measure_all(const AccuracyArguments& a, const std::vector<HardCase>& cases,
                             const std::atomic<bool>& stop) {
    std::vector<const Backend*> backends;
    for (const std::string& name : a.backends) backends.push_back(find_backend(name));
    accuracy::Budget budget;
    budget.rays = static_cast<std::uint64_t>(a.rays);
    budget.seconds = a.seconds;
    budget.textbooks = !a.only_backends;
    budget.stop = &stop;
    std::vector<Row> all;
    Keeper keeper(a, cases);
    for (const HardCase& c : cases) {
        if (stop) break;
        print_message("etalon-bench: {}/{}\n", c.id, c.variant);
        const std::vector<Row> rows = accuracy::measure(c, backends, budget);
        if (rows.empty()) print_message("  none of the backends has kernels of its own for it\n");
        write_table(a.json,
                    accuracy::table_of(rows, a.detail(), all.empty() ? "" : all.back().shape));
        all.insert(all.end(), rows.begin(), rows.end());
        keeper.keep(all);
    }
    write_table(a.json, fmt::format("\n{}", accuracy::legend(a.detail())));
    return all;
}

/// Makes the folder of the plots. Returns why the files cannot all be written, and the exit status;
/// an empty text if they can.
std::pair<std::string, int> check_files(const AccuracyArguments& a) {
    auto files = check_outputs({a.json, a.markdown}, {});
    if (!files.first.empty() || a.plots.empty()) return files;
    std::error_code failure;
    std::filesystem::create_directories(a.plots, failure);
    if (failure) return {a.plots + ": " + failure.message(), exit_not_written};
    return check_outputs({a.plots + "/shape.svg"}, {});
}

int measure_accuracy(const AccuracyArguments& a) {
    const auto [cases, unknown] = hard::cases_named(a.cases);
    if (!unknown.empty()) return fail(exit_usage, "--case " + unknown);
    if (a.list) return list_cases(cases);
    if (const auto [error, status] = check_files(a); !error.empty()) return fail(status, error);
    const SignalGuard signals;
    const std::vector<Row> rows = measure_all(a, cases, signals.raised());
    const bool stopped = signals.raised();
    if (stopped) write_table(a.json, partial);
    const auto broken = std::count_if(rows.begin(), rows.end(), is_broken_promise);
    if (broken > 0) {
        write_table(a.json,
                    fmt::format("{} rows with errors that none of them may have\n", broken));
    }
    const bool written = write_reports(a, cases, rows, stopped ? Json("signal") : Json());
    if (stopped) return exit_signal + signals.signal();
    if (!written) return exit_not_written;
    return broken > 0 ? exit_differs : exit_done;
}

}  // namespace

Action declare_accuracy(Options& options) {
    auto a = std::make_shared<AccuracyArguments>();
    options
        .add("--case", a->cases,
             "Comma-separated list of cases: SPH, SPH-1, or \"SPH-1/1e3 radii, float\" "
             "(default: all of --list)")
        .value("CASE")
        .words_by_commas();
    options.add("-b,--backends", a->backends, "Comma-separated list of backends")
        .by_commas()
        .one_of(backend_names())
        .show_default();
    options.add("--rays", a->rays, "Number of rays of each case, such as 1e7")
        .value("N")
        .within(1.0, 1e12)
        .show_default();
    options
        .add("--limit", a->seconds,
             "Time limit of each case; it may then get fewer rays (default: none)")
        .value("SECONDS")
        .positive();
    options.add_flag("--only-backends", a->only_backends,
                     "Measure backends only, not kernels by themselves");
    options.add_flag("--wide", a->wide, "Show all columns, not only those that fit 100 characters");
    options.add_flag("--list", a->list, "List the cases and exit");
    options.add("--json", a->json, "Write the results to this JSON file; - is standard output")
        .value("FILE");
    options.add("--markdown", a->markdown, "Write the table of docs/accuracy/table.md to this file")
        .value("FILE");
    options
        .add(
            "--plots", a->plots,
            "Write plots of error against cost, SHAPE.svg, to this directory; created if necessary")
        .value("DIR");
    return [a] { return measure_accuracy(*a); };
}

}  // namespace etalon
