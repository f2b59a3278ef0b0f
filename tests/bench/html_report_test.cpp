// The HTML report of made-up figures, and the report command as a process.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/report/formatting.h"
#include "bench/report/html/html.h"
#include "bench/report/sections/sections.h"
#include "bench/report/tasks.h"
#include "tests/app/run_program.h"
#include "tests/bench/report_results.h"
#include "tests/catch.h"
#include "tests/markup.h"

using namespace etalon::bench_report;
using namespace etalon::test;

namespace {

double planned_seconds(const std::vector<Task>& tasks) {
    double sum = 0;
    for (const Task& task : tasks) sum += task.seconds;
    return sum;
}

}  // namespace

TEST_CASE("A report is well-formed, whatever names it has to show, and asks nothing of a network") {
    const std::string page = html(page_of(sample_results()));
    CHECK(is_well_formed(page));
    CHECK_THAT(page, ContainsSubstring("&lt;b&gt;&quot;a&quot; &amp; b&lt;/b&gt;"));
    for (const char* outside : {"http://", "https://", "<script", "url(", "@import"}) {
        CHECK_THAT(page, !ContainsSubstring(outside));
    }
}

TEST_CASE("A report has every section, and every figure its caption, command and date") {
    const Page content = page_of(sample_results());
    for (const Section& section : content.sections) {
        INFO(section.id);
        CHECK_FALSE(section.figures.empty());
        for (const Figure& figure : section.figures) {
            INFO(figure.title);
            CHECK_FALSE(figure.title.empty());
            CHECK_FALSE(figure.caption.empty());
            CHECK_THAT(figure.command, ContainsSubstring("etalon"));
            CHECK(figure.date.size() == std::string("2026-11-21 23:08").size());
        }
    }
    const std::string page = html(content);
    CHECK(count(page, "<section ") == content.sections.size());
    CHECK(count(page, "<figcaption>") == count(page, "<figure"));
    for (const char* id : {"machine", "speed", "builds", "pareto", "convergence", "images",
                           "frames", "hard-cases", "spd", "foreign"}) {
        CHECK_THAT(page, ContainsSubstring(std::string("<section id=\"") + id + "\""));
        CHECK_THAT(page, ContainsSubstring(std::string("<a href=\"#") + id + "\""));
    }
}

TEST_CASE("A report of less than everything says so, and which of its sections are empty") {
    Results results;
    results.settings = quick_settings();
    results.missing = "It was interrupted.";
    const std::string page = html(page_of(results));
    CHECK(is_well_formed(page));
    CHECK_THAT(page, ContainsSubstring("Not complete.</b> It was interrupted."));
    CHECK(count(page, "Not measured.") == 8);  // all but the machine's
    CHECK_THAT(html(page_of(sample_results())), !ContainsSubstring("Not complete"));
    CHECK_THAT(page, !ContainsSubstring("Comparison with other programs"));
}

TEST_CASE("A report marks what is wrong and what is right") {
    const std::string page = html(page_of(sample_results()));
    CHECK_THAT(page,
               ContainsSubstring("note bad\" data-name=\"wrong\">12 of 2,174\n7 of 30 disputed<"));
    CHECK_THAT(page,
               ContainsSubstring("note good\" data-name=\"wrong\">0 of 2,174\n0 of 30 disputed<"));
    CHECK_THAT(page, ContainsSubstring("number bad\">fail: 999,999"));
    CHECK_THAT(page, ContainsSubstring("bad\">other"));
}

TEST_CASE("A report: given curves with references of their own, then each chart names its own") {
    Results results = sample_results();
    ConvergenceFigures other = results.convergence.list.front();
    other.reference = "512 samples per pixel";
    results.convergence.list.front().reference = "2048 samples per pixel";
    results.convergence.add(other);
    const Figure figure = convergence_section(results).figures.front();
    const Charts& charts = std::get<Charts>(figure.content);
    REQUIRE(charts.charts.size() == 2);
    CHECK(charts.charts[0].remarks ==
          std::vector<std::string>{"The reference has 2048 samples per pixel."});
    CHECK(charts.charts[1].remarks ==
          std::vector<std::string>{"The reference has 512 samples per pixel."});
    CHECK_THAT(figure.caption, !ContainsSubstring("2048"));
}

TEST_CASE("A report's bars are as long as their values") {
    const Bars bars{
        {{"g", "", "", "", {{"a", 1, 2, 0, "2", "", {}}, {"b", 2, 0.5, 0, "", "", {}}}}}};
    CHECK_THAT(html(bars), ContainsSubstring("class=\"b1\" width=\"1000.0\"") &&
                               ContainsSubstring("class=\"b2\" width=\"250.0\""));
}

TEST_CASE("Base64 is that of RFC 4648") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xff\xfe\xfd") == "//79");
}

TEST_CASE("Numbers of a report are short and grouped") {
    CHECK(etalon::grouped(0) == "0");
    CHECK(etalon::grouped(999) == "999");
    CHECK(etalon::grouped(1411230) == "1,411,230");
    CHECK(three_digits(0.99949) == "0.999");
    CHECK(three_digits(0.9996) == "1.00");
    CHECK(three_digits(1234.4) == "1,234");
    CHECK(times({1.024, 0.031}) == "×1.02 ± 0.03");
    CHECK(duration(9.96) == "10 s");
    CHECK(duration(125) == "2 min");
    CHECK(duration(3900) == "1 h 5 min");
    CHECK(bytes(999) == "999 B");
    CHECK(bytes(12345) == "12.3 kB");
}

TEST_CASE(
    "The quick report has every kind of task and keeps its own limit; the full one has more") {
    const Settings quick = quick_settings(), full = full_settings();
    for (const auto tasks :
         {image_tasks, speed_tasks, accuracy_tasks, frame_tasks, spd_tasks, convergence_tasks}) {
        CHECK_FALSE(tasks(quick).empty());
        CHECK(planned_seconds(tasks(full)) >= planned_seconds(tasks(quick)));
    }
    CHECK(planned_seconds(all_tasks(quick)) < quick.seconds_limit);
    CHECK(planned_seconds(all_tasks(full)) > planned_seconds(all_tasks(quick)));
}

TEST_CASE("A report beside other programs has their ratios, and tasks for each of their scenes") {
    const Page page = page_of(sample_results());
    const auto section = std::ranges::find(page.sections, "foreign", &Section::id);
    REQUIRE(section != page.sections.end());
    REQUIRE(section->figures.size() == 4);
    const Table& means = std::get<Table>(section->figures[0].content);
    CHECK(means.rows[0][1].text == "1");
    CHECK(means.rows[0][2].text == "×6.67");  // 2 s beside 0.1 s and 0.2 s; 40 s is extrapolated
    const Table& ratios = std::get<Table>(section->figures[2].content);
    REQUIRE(ratios.rows.size() == 2);
    CHECK_THAT(ratios.rows[1][6].text, ContainsSubstring("≈"));
    const Table& missing = std::get<Table>(section->figures[3].content);
    CHECK(missing.rows[0][0].text == "other");
    CHECK(foreign_tasks(quick_settings()).empty());
    const Folder f;
    f.write("t.tsv", "scene\tcpu_s\trelmse\na.pbrt\t1\t1\nb.pbrt\t1\t1\na.pbrt\t2\t0.5\n");
    Settings settings = quick_settings();
    REQUIRE(add_foreign(f.path("t.tsv"), settings).empty());
    CHECK(foreign_tasks(settings).size() == 2);
    CHECK(planned_seconds(all_tasks(settings)) < settings.seconds_limit);
    f.write("t.tsv", "cpu_s\trelmse\n1\t1\n");
    settings = quick_settings();
    CHECK_THAT(add_foreign(f.path("t.tsv"), settings), ContainsSubstring("no column named scene"));
}

TEST_CASE("A report that is interrupted leaves a page with what there is") {
    const Folder f;
    const auto r = f.shell("'" ETALON_BINARY_DIR
                           "/bin/etalon-bench' report --quick -o here/there & "
                           "while kill -0 $! && ! test -e here/there/index.html; do "
                           "sleep 0.05; done; kill -INT $!; wait $!");
    CHECK(r.status == 130);
    CHECK_THAT(r.out, ContainsSubstring("here/there/index.html"));
    CHECK_THAT(r.err, ContainsSubstring("report takes about"));
    const std::string page = f.read("here/there/index.html");
    CHECK(is_well_formed(page));
    CHECK_THAT(page, ContainsSubstring("Not complete.</b> It was interrupted after"));
}

TEST_CASE("A report says at once where it cannot be written") {
    const Folder f;
    f.write("file", "");
    const std::string report = "exec '" ETALON_BINARY_DIR "/bin/etalon-bench' report --quick -o ";
    CHECK(f.shell(report + "file").status == 4);
    CHECK(f.shell(report + "file/below").status == 4);
}
