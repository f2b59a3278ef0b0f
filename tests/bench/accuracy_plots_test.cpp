// Texts in the plots of etalon-bench accuracy.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/accuracy/report/remarks.h"
#include "bench/report/html/html.h"
#include "bench/report/sections/sections.h"
#include "tests/accuracy/report_rows.h"
#include "tests/app/run_program.h"
#include "tests/bench/report_results.h"
#include "tests/catch.h"

using namespace etalon::accuracy;
using namespace etalon::test;

using nlohmann::json;

namespace {

/// Measures a case with plots and JSON in the folder.
void measure(const Folder& f, const std::string& arguments, const std::string& plots = ".") {
    const auto r = f.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' accuracy --plots " +
                           plots + " --json a.json " + arguments);
    REQUIRE(r.status == 0);
}

}  // namespace

TEST_CASE("A plot of cases that had no time for all their rays says so, as does their JSON") {
    const Folder f;
    measure(f, "--case SPH-3 --backends bvh --rays 1e6 --limit 0.000001");
    CHECK_THAT(f.read("sphere.svg"), ContainsSubstring("Partial: "));
    const json cut = json::parse(f.read("a.json"))["rows"][0];
    CHECK(cut["partial"] == true);
    CHECK(cut["rays"] < 1000000);
    measure(f, "--case SPH-3 --backends bvh --rays 20");
    CHECK_THAT(f.read("sphere.svg"), !ContainsSubstring("Partial"));
    CHECK(json::parse(f.read("a.json"))["rows"][0]["partial"] == false);
}

TEST_CASE("accuracy: given a folder for plots that is not there, then it is made if it can be") {
    const Folder f;
    const std::string arguments = "--case SPH-3 --backends bvh --rays 20 ";
    measure(f, arguments, "new/plots");
    CHECK(f.has("new/plots/sphere.svg"));
    const auto r = f.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' accuracy " + arguments +
                           "--plots a.json/plots");
    CHECK(r.status == 4);
    CHECK(r.err == "etalon-bench: error: a.json/plots: Not a directory\n");
}

TEST_CASE("A plot has no remark where backends that are never wrong find t to the last bits") {
    const Folder f;
    for (const char* const hard : {"\"AIM-2/cone along an axis\"", "CON-2"}) {
        measure(f, fmt::format("--case {} --backends bvh --rays 1024", hard));
        CHECK_THAT(f.read("cone.svg"), ContainsSubstring("bvh") && !ContainsSubstring("roundoff"));
    }
}

TEST_CASE("Remarks are worked out from the rows: a condition that is too large is not excused") {
    std::vector<Row> rows{row("A", "cone", "bvh", 5000, 0, 1)};
    const auto remark = [&] { return remarks_on(rows, "cone", 1).at(0); };
    CHECK_THAT(remark(), ContainsSubstring("more than the rounding of the input explains"));
    rows[0].stats.conditioned = {};
    rows[0].stats.conditioned.add(2.5);
    CHECK_THAT(remark(), ContainsSubstring("The 5000 ulp") &&
                             ContainsSubstring("at most 2.50 times") &&
                             ContainsSubstring("does not decide"));
    CHECK(remarks_on({row("A", "cone", "bvh", 0.5, 0, 1)}, "cone", 1).empty());
    CHECK_THAT(remarks_on({row("A", "cone", "bvh", 0.5, 0, 1)}, "cone", 3).at(0),
               ContainsSubstring("Partial: 1 of 3 cases were measured, 0 of them"));
}

TEST_CASE("The report has the remarks below its plots") {
    using namespace etalon::bench_report;
    CHECK_THAT(html(page_of(sample_results())),
               ContainsSubstring("<p class=\"remark\">Partial: 2 of "));
}
