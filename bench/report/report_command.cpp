// etalon-bench report: runs all measurements and writes one page.
#include <fmt/ranges.h>

#include <filesystem>
#include <set>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/output.h"
#include "app/common/progress.h"
#include "app/common/signals.h"
#include "bench/bench_subcommands.h"
#include "bench/report/data_files.h"
#include "bench/report/formatting.h"
#include "bench/report/html/html.h"
#include "bench/report/sections/sections.h"
#include "bench/report/tasks.h"

namespace etalon {
namespace {

using namespace bench_report;

struct ReportArguments {
    std::string folder = "report";
    std::vector<std::string> scenes;
    std::string foreign;
    bool quick = false;
};

double total(const std::vector<Task>& tasks) {
    double seconds = 0;
    for (const Task& task : tasks) seconds += task.seconds;
    return seconds;
}

Results nothing_yet(const Settings& settings) {
    Results results;
    results.settings = settings;
    results.begun = date_now();
    results.machine = this_machine();
    return results;
}

/// One run of the command. The page and its data are rewritten after every task, so that they are
/// up to date whenever the run ends.
class Report {
  public:
    explicit Report(const Settings& settings)
        : folder_(settings.folder),
          path_((std::filesystem::path(folder_) / "index.html").string()),
          results_(nothing_yet(settings)),
          deadline_(results_.settings.seconds_limit),
          tasks_(all_tasks(results_.settings)),
          seconds_(total(tasks_)) {}

    int run() {
        announce();
        if (!write("It is being measured: nothing yet.")) return exit_not_written;
        if (!measure()) return exit_not_written;
        if (!write(missing()) || !write_tables(folder_, page_of(results_))) {
            return exit_not_written;
        }
        if (!results_.missing.empty()) {
            print_message("etalon-bench: warning: the report is incomplete: {}\n",
                          results_.missing);
        }
        warn_of_old_tables();
        print_result("{}\n", path_);
        return signals_.signal() != 0 ? exit_signal + signals_.signal() : exit_done;
    }

  private:
    void announce() const {
        print_message(
            "etalon-bench: the {} report takes about {} on two free cores; Ctrl-C ends it "
            "with what there is{}\n",
            results_.settings.name, duration(seconds_),
            results_.settings.name == "quick" ? "" : ", --quick takes two minutes");
    }

    /// Returns false if the results cannot be written.
    bool measure() {
        Progress progress("report");
        double before = 0;
        for (; done_ < tasks_.size() && !is_over(); ++done_) {
            const Task& task = tasks_[done_];
            const auto tell = [&](double part) {
                progress.update((before + part * task.seconds) / seconds_);
            };
            task.run(results_, {signals_.raised(), deadline_, tell});
            before += task.seconds;
            if (!write(fmt::format("It is being measured: {} of {} parts are done.", done_ + 1,
                                   tasks_.size())))
                return false;
        }
        return true;
    }

    void warn_of_old_tables() const {
        const std::vector<std::string> names = old_tables(folder_, page_of(results_));
        if (names.empty()) return;
        print_message("etalon-bench: warning: {}: of an earlier report, not of this one: {}\n",
                      folder_, fmt::join(names, ", "));
    }

    bool is_over() const { return signals_.raised() || deadline_.is_over(); }

    double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    /// Returns why the report is incomplete, or nothing. The last task may be interrupted.
    std::string missing() const {
        if (signals_.signal() == 0 && done_ == tasks_.size()) return {};
        const char* why = signals_.signal() != 0 ? "It was interrupted" : "Its time was up";
        return fmt::format("{} after {}, when {} of {} parts had been begun.", why,
                           duration(elapsed()), done_, tasks_.size());
    }

    bool write(const std::string& missing) {
        results_.missing = missing;
        const Page page = page_of(results_);
        return write_text(path_, html(page)) && write_data(folder_, results_, page);
    }

    const SignalGuard signals_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const std::string folder_, path_;
    Results results_;
    const Deadline deadline_;
    const std::vector<Task> tasks_;
    const double seconds_;  ///< estimated time of all tasks
    std::size_t done_ = 0;
};

/// Returns the files that the settings name.
std::set<std::string> inputs_of(const Settings& settings) {
    std::set<std::string> files{settings.foreign_table};
    for (const FrameRequest& frame : settings.frames) {
        if (frame.origin == FrameOrigin::given) files.insert(frame.scene);
    }
    for (const ForeignRequest& request : settings.foreign) {
        files.insert(request.scene);
        for (const convergence::ForeignImage& image : request.images) {
            files.insert({image.image, image.reference});
        }
    }
    files.erase("");
    return files;
}

/// Returns which input the report would replace; empty if none.
std::string find_lost_input(const Settings& settings) {
    const Page page = page_of(nothing_yet(settings));
    const std::filesystem::path folder = settings.folder;
    std::set<std::string> outputs{folder / "index.html", folder / "data.json"};
    const std::set<std::string> inputs = inputs_of(settings);
    for (const std::string& input : inputs) {
        const std::filesystem::path name = std::filesystem::path(input).filename();
        if (is_file_of_report(name, page)) outputs.insert(folder / name);
    }
    return find_clash({outputs.begin(), outputs.end()}, {inputs.begin(), inputs.end()});
}

int write_report(const ReportArguments& a) {
    Settings settings = a.quick ? quick_settings() : full_settings();
    settings.folder = a.folder;
    std::string error = add_frames(a.scenes, settings);
    if (!error.empty()) return fail(exit_unusable, error);
    if (!a.foreign.empty()) error = add_foreign(a.foreign, settings);
    if (!error.empty()) {
        print_message("{}\n", error);
        return exit_unusable;
    }
    if (error = find_lost_input(settings); !error.empty()) return fail(exit_usage, error);
    std::error_code failure;
    std::filesystem::create_directories(a.folder, failure);
    if (failure) return fail(exit_not_written, a.folder + ": " + failure.message());
    return Report(settings).run();
}

}  // namespace

Action declare_report(Options& options) {
    auto a = std::make_shared<ReportArguments>();
    options.add("SCENE", a->scenes,
                "Scene files, and folders of them, whose frames are measured too");
    options
        .add("--foreign", a->foreign,
             "Compare with other programs, too: their images of PBRT scenes in this table, which "
             "docs/convergence.md describes")
        .value("TABLE");
    options
        .add("-o,--output", a->folder,
             "Directory of index.html, data.json and a CSV of each table; created if necessary")
        .value("DIR")
        .show_default();
    options.add_flag("--quick", a->quick,
                     "Measure for two minutes only (default: longer; the time is announced first)");
    return [a] { return write_report(*a); };
}

}  // namespace etalon
