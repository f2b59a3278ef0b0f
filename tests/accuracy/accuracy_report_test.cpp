#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/accuracy/report/accuracy_json.h"
#include "bench/accuracy/report/accuracy_table.h"
#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/markdown.h"
#include "bench/accuracy/report/numbers.h"
#include "tests/accuracy/report_rows.h"
#include "tests/catch.h"

using namespace etalon::accuracy;
using etalon::table::Detail;

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> list;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) list.push_back(word);
    return list;
}

/// The lines of the table that have cells.
std::vector<std::string> lines_of_tracers(const std::string& table) {
    std::vector<std::string> lines;
    for (const std::string& line : split(table, '\n')) {
        if (line.starts_with("  ") && line[2] != ' ') lines.push_back(line);
    }
    return lines;
}

using Counts = std::vector<std::uint64_t>;

Counts counts_of(const ErrorStats& t) {
    return {t.rays,           t.undecidable,      t.false_hits, t.false_misses,
            t.wrong_roots,    t.wrong_primitives, t.leaks,      t.self_hits,
            t.contradictions, t.deviations};
}

Counts counts_in(const nlohmann::ordered_json& row) {
    Counts counts;
    for (const char* name :
         {"rays", "undecidable", "false_hits", "false_misses", "wrong_roots", "wrong_primitives",
          "leaks", "self_hits", "contradictions", "deviations"}) {
        counts.push_back(row[name]);
    }
    return counts;
}

bool is_written(const Distribution& d, const nlohmann::ordered_json& json) {
    return json["count"] == d.count() && json["p50"] == d.quantile(0.5) &&
           json["p99"] == d.quantile(0.99) && json["max"] == d.max();
}

}  // namespace

TEST_CASE("A tracer without a hit has no error of t in the table") {
    Row missing = row("SPH-1", "sphere", "bvh", 1e-9, 0, 9.3);
    missing.stats = ErrorStats();
    missing.stats.rays = 1000000;
    const auto cells = [](const Row& r) {
        return words(lines_of_tracers(table_of({r}, Detail::narrow, "")).front());
    };
    CHECK(cells(missing)[6] == "-");
    CHECK(cells(row("SPH-1", "sphere", "bvh", 1e-9, 0, 9.3))[6] == "1e-9");
}

TEST_CASE("A brief number takes at most six characters and keeps its size") {
    for (int exponent = -300; exponent <= 300; ++exponent) {
        for (const double digits : {1.0, 1.25, 5.123, 9.96, 9.9999}) {
            const double value = digits * std::pow(10, exponent);
            const std::string text = brief(value);
            INFO(value << " " << text);
            if (std::abs(exponent) < 99) CHECK(text.size() <= 6);
            const bool is_tiny = value < 1e-9;
            CHECK(std::stod(text) == Approx(value).epsilon(is_tiny ? 0.34 : 0.051));
        }
    }
    CHECK(brief(0) == "0");
    CHECK(brief(12.34) == "12.3");
    CHECK(brief(9087) == "9087");
    CHECK(brief(46227) == "4.6e4");
    CHECK(brief_count(999999) == "999999");
    CHECK(brief_count(2500000) == "2.5e6");
}

TEST_CASE("The columns of the table line up, and no two cells touch") {
    const std::vector<std::string> lines = lines_of_tracers(table_of(sample_rows(), Detail::wide));
    REQUIRE(lines.size() == sample_rows().size());
    for (const std::string& line : lines) {
        INFO(line);
        CHECK(line.size() == lines.front().size());
        CHECK(line.size() <= 200);
        const std::size_t words_of_name = line.find("textbook") == std::string::npos ? 1 : 2;
        CHECK(words(line).size() == 22 + words_of_name);
    }
}

TEST_CASE(
    "The table shows errors, dots for none, and nothing that the criterion does not look at") {
    const std::vector<std::string> lines = lines_of_tracers(table_of(sample_rows(), Detail::wide));
    const std::vector<std::string> bvh = words(lines[0]), builtin = words(lines[2]);
    CHECK(bvh[0] == "bvh");
    CHECK(bvh[2] == ".");
    CHECK(builtin[2] == "999999");
    CHECK(builtin[7] == "-");  // leaks
    const std::vector<std::string> enclosed = words(lines[13]);
    CHECK(enclosed[0] == "embree-builtin");
    CHECK(enclosed[3] == "-");  // false hits
    CHECK(enclosed[7] == "240000");
}

TEST_CASE("JSON keeps every number to the last bit through writing and reading") {
    std::vector<Row> rows = sample_rows();
    rows[0].stats = {12345678901234567U, 2, 3, 4, 5, 6, 7, 8, 9, 10, {}, {}, {}, {}, {}};
    const auto written = json(rows);
    const auto read = nlohmann::ordered_json::parse(written.dump());
    CHECK(read == written);
    CHECK(read["schema"] == 1);
    REQUIRE(read["rows"].size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& r = read["rows"][i];
        const ErrorStats& t = rows[i].stats;
        CHECK(r["tracer"] == rows[i].tracer);
        CHECK(r["judge"] == rows[i].criterion);
        CHECK(counts_in(r) == counts_of(t));
        CHECK(r["errors"].get<std::uint64_t>() == t.errors());
        CHECK(r["nanoseconds"].get<double>() == rows[i].nanoseconds);
        CHECK(is_written(t.float_ulps, r["t_float_ulps"]));
        CHECK(is_written(t.double_ulps, r["t_double_ulps"]));
        CHECK(is_written(t.conditioned, r["conditioned"]));
        CHECK(is_written(t.position, r["position"]));
        CHECK(is_written(t.shift, r["shift"]));
    }
}

TEST_CASE("Markdown has a heading for each shape and as many cells in every line as in the head") {
    std::size_t headings = 0, cells = 0;
    for (const std::string& line : split(markdown(sample_rows()), '\n')) {
        if (line.starts_with("## ")) ++headings;
        if (line.starts_with("| case")) cells = split(line, '|').size();
        if (line.starts_with("|")) CHECK(split(line, '|').size() == cells);
    }
    CHECK(headings == 2);
}

TEST_CASE("Markdown has the number of rays of the tracers that were given most") {
    std::vector<Row> rows{row("TRI-3", "scene", "none", 0, 0, 0),
                          row("TRI-3", "scene", "bvh", 0, 0, 0)};
    rows[0].stats.rays = 1000;
    rows[1].stats.rays = 60000;
    rows[1].stats.undecidable = 70;
    CHECK_THAT(markdown(rows), ContainsSubstring("| 60000 | 70 | 0 in 2 backends |"));
}

TEST_CASE("Errors are a share of the rays that the oracle decides") {
    ErrorStats stats;
    CHECK(errors_per_million(stats) == 0);
    stats.rays = 1000;
    stats.undecidable = 600;
    stats.false_hits = 1;
    CHECK(errors_per_million(stats) == 2500);
    stats.undecidable = stats.rays;
    CHECK(errors_per_million(stats) == 0);
}

TEST_CASE("Markdown has one figure for the exact backends, and all of them where they differ") {
    std::vector<Row> rows{row("SPH-1", "sphere", "bvh", 0, 0, 0),
                          row("SPH-1", "sphere", "embree", 0, 0, 0)};
    CHECK_THAT(markdown(rows), ContainsSubstring("| 0 in 2 backends |"));
    rows[1].stats.leaks = 3;
    CHECK_THAT(markdown(rows), ContainsSubstring("| bvh 0, embree 3 |"));
}
