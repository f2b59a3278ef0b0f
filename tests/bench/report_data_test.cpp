// Key figures of the report, and its machine-readable figures.
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "bench/accuracy/measure_case.h"
#include "bench/hard_cases/case_families.h"
#include "bench/report/data_files.h"
#include "bench/report/html/html.h"
#include "bench/report/sections/sections.h"
#include "tests/bench/report_results.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::bench_report;
using namespace etalon::test;

using nlohmann::json;

namespace {

const KeyFigure& key_figure(const Page& page, const std::string& name, const std::string& note) {
    for (const KeyFigure& figure : page.summary) {
        if (figure.name.find(name) != std::string::npos &&
            figure.note.find(note) != std::string::npos) {
            return figure;
        }
    }
    FAIL("no key figure " << name << ", " << note);
    return page.summary.front();
}

json written_data(const Results& results, const TemporaryFolder& folder) {
    REQUIRE(write_data(folder / ".", results, page_of(results)));
    REQUIRE(write_tables(folder / ".", page_of(results)));
    return json::parse(content_of(folder / "data.json"));
}

}  // namespace

TEST_CASE("Tables of an earlier report are told from those of this one, and from other files") {
    const TemporaryFolder folder;
    written_data(sample_results(), folder);
    const Page page = page_of(sample_results());
    CHECK(old_tables(folder / ".", page).empty());
    for (const char* name : {"frames-old.csv", "speed-older.csv", "speed.csv", "frames-old.txt"}) {
        std::ofstream(folder / name) << "a";
    }
    CHECK(old_tables(folder / ".", page) ==
          std::vector<std::string>{"frames-old.csv", "speed-older.csv"});
}

TEST_CASE("A ray of the hard cases is counted once, however many backends answer it") {
    const Page page = page_of(sample_results());
    // Two cases of a sphere and two of a scene, of a million rays each.
    CHECK_THAT(key_figure(page, "wrong answers", "exact").note, ContainsSubstring("4,000,000"));
    const KeyFigure& float_errors = key_figure(page, "wrong answers", "embree-builtin");
    CHECK_THAT(float_errors.note, ContainsSubstring("4,000,000"));
    CHECK(float_errors.value == "56.0 %");  // (2 x 999,999 + 240,000) of 4,000,000
}

TEST_CASE("Rays that the oracle cannot decide are no hard rays of a report") {
    Results results = sample_results();
    for (accuracy::Row& row : results.rows.list) row.stats.undecidable = 250000;
    const Page page = page_of(results);
    CHECK_THAT(key_figure(page, "wrong answers", "exact").note, ContainsSubstring("3,000,000"));
    CHECK(key_figure(page, "wrong answers", "embree-builtin").value == "74.7 %");
}

TEST_CASE("A hit at another distance is another hit, of backends that promise all bits") {
    Results results = sample_results();
    for (speed::RayFigures& r : results.scenes.list.front().kinds.front().tracers) {
        r.errors.disagreement = {1000, 0, 1, 3};
    }
    std::map<std::string, std::string> other_hits;
    for (const Figure& figure : speed_section(results).figures) {
        const auto* table = std::get_if<Table>(&figure.content);
        if (table == nullptr || figure.title != "All numbers of this section") continue;
        const auto column = std::ranges::find(table->columns, "other hits", &Column::name);
        REQUIRE(column != table->columns.end());
        for (const auto& row : table->rows) {
            other_hits[row[2].text] = row[column - table->columns.begin()].text;
        }
    }
    CHECK(other_hits["bvh"] == "4");
    CHECK(other_hits["embree-builtin"] == "1");
    CHECK(other_hits["embree-builtin-robust"] == "1");
}

TEST_CASE("A report has a speed for each kind of scene, and what it lies between") {
    Results results = sample_results();
    speed::SceneFigures other = results.scenes.list.front();
    other.shape = "triangle";
    results.scenes.add(other);
    const Page page = page_of(results);
    for (const char* shape : {"sphere", "triangle"}) {
        const KeyFigure& figure = key_figure(page, std::string(shape) + " scenes", "bvh");
        CHECK_THAT(figure.note, ContainsSubstring("over 1 scene"));
        CHECK(figure.value == "×1.33");
    }
}

TEST_CASE("A report's speed of builds has a spread as well, and its page the commit") {
    Results results = sample_results();
    results.machine.commit = "0123456789ab";
    speed::SceneFigures other = results.scenes.list.front();
    for (speed::BuildFigures& b : other.builds) b.by_threads.front().ratio.median = 0.5;
    results.scenes.add(other);
    const Page page = page_of(results);
    const KeyFigure& figure = key_figure(page, "build speed", "bvh");
    CHECK_THAT(figure.note, ContainsSubstring("×0.500 to ×") && ContainsSubstring("over 2 scenes"));
    CHECK_THAT(html(page), ContainsSubstring("commit 0123456789ab"));
}

TEST_CASE("The time of a build on several threads is short, and its heading says on how many") {
    Results results = sample_results();
    for (speed::BuildFigures& b : results.scenes.list[0].builds) {
        b.by_threads.push_back(b.by_threads.front());
        b.by_threads.back().threads = 2;
    }
    const Section section = builds_section(results);
    const BarGroup& times = std::get<Bars>(section.figures.at(0).content).groups.at(0);
    CHECK(times.note == "on 2 threads");
    CHECK_THAT(section.figures[0].caption, ContainsSubstring("the time on several threads"));
    const Section on_one = builds_section(sample_results());
    CHECK_THAT(on_one.figures[0].caption, !ContainsSubstring("several threads"));
    for (const Bar& bar : times.bars) CHECK(bar.note.text.ends_with(" ms"));
}

TEST_CASE("A report says when the machine was busy") {
    Results results = sample_results();
    results.machine.cores = 2;
    results.machine.load = 0.1;
    CHECK_THAT(html(page_of(results)), !ContainsSubstring("Doubtful"));
    results.machine.load = 1.5;
    CHECK_THAT(html(page_of(results)),
               ContainsSubstring("Doubtful") && ContainsSubstring("a load of 1.50 on 2 cores"));
}

TEST_CASE("data.json holds what the key figures are worked out from") {
    const TemporaryFolder folder;
    const Results results = sample_results();
    const json data = written_data(results, folder);
    CHECK(data["schema"] == 1);
    double logs = 0;
    int count = 0;
    for (const json& scene : data["speed"]) {
        CHECK(scene["shape"] == "sphere");
        for (const json& kind : scene["rays"]) {
            logs += std::log(kind["bvh"]["ratio"].get<double>());
            ++count;
        }
    }
    CHECK(std::exp(logs / count) == Approx(1 / 0.75).epsilon(0.01));
    CHECK(data["key_figures"].size() == page_of(results).summary.size());
    CHECK(data["frames"].size() == 3);
    CHECK(data["frames"][2]["origin"] == "given");
    CHECK(data["spd"][0]["backends"]["bvh"]["rays"].is_number());
    CHECK(data["convergence"][0]["curves"].size() == 2);
    CHECK(data["foreign"][0]["comparisons"][0]["ratio"] == Approx(20 / 3.0));
    CHECK(data["foreign"][1]["curve"].empty());
}

TEST_CASE("Each table of a report is a CSV file, with what CSV takes for its own in quotes") {
    const TemporaryFolder folder;
    const Results results = sample_results();
    written_data(results, folder);
    std::size_t tables = 0;
    for (const Section& section : page_of(results).sections) {
        for (const Figure& figure : section.figures) {
            tables += std::holds_alternative<Table>(figure.content) ? 1 : 0;
        }
    }
    CHECK(folder.names().size() == tables + 1);
    const std::string csv = content_of(folder / "machine-machine.csv");
    CHECK_THAT(csv, ContainsSubstring("processor,\"<b>\"\"a\"\" & b</b>\"\r\n"));
}

TEST_CASE("A tracer that gets fewer rays of a case than asked for has a partial row") {
    accuracy::Budget budget;
    budget.rays = 3 << 12;
    budget.tests = 1;
    budget.textbooks = false;
    const auto rows = accuracy::measure(hard::sphere_cases().front(),
                                        {find_backend("none"), find_backend("bvh")}, budget);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].stats.rays < budget.rays);
    CHECK(rows[0].partial);
    CHECK_FALSE(rows[1].partial);
    for (const hard::HardCase& c : hard::hard_cases()) {
        if (c.id != "SPN-4") continue;
        for (const accuracy::Row& row : accuracy::measure(c, {find_backend("bvh")}, budget)) {
            CHECK(row.stats.rays < budget.rays);  // not all meet a surface to leave
            CHECK_FALSE(row.partial);
        }
        break;
    }
}

TEST_CASE("What was interrupted before its first figure is empty in the data, not absent") {
    const TemporaryFolder folder;
    Results results = sample_results();
    for (ConvergenceFigures& figures : results.convergence.list) figures.curves.clear();
    for (SpdFigures& figures : results.spd.list) figures.runs.clear();
    REQUIRE(write_data(folder / ".", results, page_of(results)));
    const json data = json::parse(content_of(folder / "data.json"));
    CHECK(data["convergence"][0].at("curves") == json::array());
    CHECK(data["spd"][0].at("backends") == json::object());
}

TEST_CASE("Embree's own kernels take part in the cases of shapes that Embree has") {
    accuracy::Budget budget;
    budget.rays = 64;
    budget.textbooks = false;
    const std::vector<const Backend*> backends{find_backend("bvh"), find_backend(baseline_backend)};
    const auto tracers = [&](const std::vector<hard::HardCase>& cases) {
        return accuracy::measure(cases.front(), backends, budget).size();
    };
    CHECK(tracers(hard::sphere_cases()) == 2);
    CHECK(tracers(hard::triangle_cases()) == 2);
    CHECK(tracers(hard::cone_cases()) == 1);
    CHECK(tracers(hard::box_cases()) == 1);
}
