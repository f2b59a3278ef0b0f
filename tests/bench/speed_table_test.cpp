// The tables of etalon-bench speed for made-up figures.
#include "bench/speed/report/speed_table.h"

#include <sstream>

#include "tests/catch.h"

using namespace etalon::speed;

namespace {

/// The lines of a text that begin with a word.
std::vector<std::string> lines_with(const std::string& word, const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(word)) lines.push_back(line);
    }
    return lines;
}

std::vector<Runs> runs_of(const std::vector<int>& threads, double seconds) {
    std::vector<Runs> list = runs_on(threads);
    for (Runs& runs : list) {
        runs.repeats = {{seconds, seconds}};
        runs.ratio = runs.ratio_robust = {0.25 / seconds, 0.125};
        runs.cpu_scaling = runs.wall_scaling = {1.5, 0};
    }
    return list;
}

void check_alike_in_length(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        INFO(line);
        CHECK(line.size() == lines.front().size());
    }
}

}  // namespace

TEST_CASE("Given rays of both kinds of query, the columns line up with their heading") {
    Errors errors;
    errors.reference = "embree-user";
    errors.sample.rays = 2174;
    errors.disputed.rays = 3;
    for (const bool occlusion : {false, true}) {
        const KindFigures kind{
            "camera",
            100'000,
            occlusion,
            {{"bvh", runs_of({1}, 0.125), errors}, {robust_baseline, runs_of({1}, 2.5), errors}}};
        std::vector<std::string> lines = lines_with("camera ", table_of(kind, Detail::narrow));
        REQUIRE(lines.size() == 2);
        CHECK_THAT(lines[0], ContainsSubstring("camera bvh "));
        CHECK_THAT(lines[1], ContainsSubstring(std::string("camera ") + robust_baseline));
        for (const std::string& line : lines_with("rays ", heading_of_rays(Detail::narrow)))
            lines.push_back(line);
        CHECK(lines.size() == 3);
        check_alike_in_length(lines);
    }
}

TEST_CASE("Given a single repeat, a ratio has no spread") {
    for (const bool is_known : {true, false}) {
        std::vector<Runs> runs = runs_of({1}, 0.125);
        if (!is_known) runs.front().ratio.spread.reset();
        const KindFigures kind{"camera", 100'000, false, {{"bvh", runs, {}}}};
        const std::string line = lines_with("camera ", table_of(kind, Detail::narrow)).front();
        CHECK((line.find(" 0.125 ") != std::string::npos) == is_known);
        CHECK((line.find(" 2.000     - ") != std::string::npos) != is_known);
    }
}

TEST_CASE("Given two numbers of threads, errors stand in the line of the first") {
    Errors errors;
    errors.reference = "embree-user";
    const KindFigures kind{"camera", 100'000, false, {{"bvh", runs_of({1, 2}, 0.125), errors}}};
    const std::vector<std::string> lines = lines_with("camera ", table_of(kind, Detail::wide));
    REQUIRE(lines.size() == 2);
    CHECK_THAT(lines[0], ContainsSubstring("embree-user"));
    CHECK_THAT(lines[1], !ContainsSubstring("embree-user"));
}

TEST_CASE("Given builds, the columns line up with their heading") {
    const std::vector<BuildFigures> builds{{"bvh", "avx2", 64.25, runs_of({1, 2}, 0.125)},
                                           {robust_baseline, "avx2", 1234.5, runs_of({1, 2}, 2.5)}};
    const std::vector<std::string> lines = lines_with("build", table_of(builds, Detail::narrow));
    CHECK(lines.size() == 5);  // with the heading
    check_alike_in_length(lines);
}
