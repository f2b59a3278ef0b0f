// The tables printed by etalon-bench: fitted to the terminal, and with a legend.
#include <algorithm>
#include <sstream>

#include "bench/table/columns.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::table;
using namespace etalon::test;

namespace {

std::string printed(const std::string& arguments) {
    const Folder f;
    const auto r = f.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' " + arguments);
    CHECK(r.status == 0);
    return r.out;
}

/// Number of characters of the longest line of a UTF-8 text.
std::ptrdiff_t longest_line(const std::string& text) {
    std::ptrdiff_t longest = 0;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        const auto characters =
            std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
        longest = std::max(longest, characters);
    }
    return longest;
}

const std::string long_name(120, 'x');

}  // namespace

TEST_CASE("The tables of etalon-bench fit a hundred characters, and all columns are explained") {
    const std::string speed =
        "speed --scene spheres:20 --repeat 1 --threads 1,2 --max-rays 64 --oracle 0.01";
    const std::string frames = "frames spheres:20 --width 20 --repeat 1";
    const std::string convergence = "convergence spheres:20 --width 10 --spp 4 --seeds 1";
    const std::string accuracy = "accuracy --rays 1 --backends bvh,embree-builtin";
    CHECK(longest_line(printed(convergence)) <= 100);
    for (const std::string& command : {speed, frames, accuracy}) {
        INFO(command);
        const std::string narrow = printed(command), wide = printed(command + " --wide");
        CHECK(longest_line(narrow) <= 100);
        CHECK(longest_line(wide) > 100);
    }
}

TEST_CASE("Each table says below what its columns mean, with --wide those of its further ones") {
    const auto has = [](const std::string& text, const std::string& name) {
        return text.find("\n  " + name + "  ") != std::string::npos;
    };
    const std::string speed = "speed --scene spheres:20 --rays camera --repeat 1 --max-rays 64";
    const std::string narrow = printed(speed), wide = printed(speed + " --wide");
    for (const char* name : {"Mrays/s CPU", "to builtin", "+-", "disputed wrong", "mean"}) {
        INFO(name);
        CHECK((has(narrow, name) && has(wide, name)));
    }
    CHECK((!has(narrow, "bits of t") && has(wide, "bits of t")));
    CHECK(has(printed("accuracy --case PLN-1 --rays 1"), "K"));
    CHECK(has(printed("accuracy --case PLN-1 --rays 1 --wide"), "contradicted"));
    CHECK(has(printed("frames spheres:20 --width 20 --repeat 1"), "inters."));
    CHECK(has(printed("convergence spheres:20 --width 10 --spp 4 --seeds 1"), "relMSE"));
}

TEST_CASE("A scene with a long path is shortened in tables") {
    const Folder f;
    f.write(long_name + ".p3f", small_scene);
    for (const char* command :
         {"speed --backends bvh --rays camera --repeat 1 --max-rays 64 --oracle 0.01 --scene ",
          "frames --width 10 --repeat 1 ", "convergence --width 10 --spp 4 --seeds 1 "}) {
        const auto r = f.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' " +
                               std::string(command) + long_name + ".p3f");
        INFO(command);
        CHECK(r.status == 0);
        CHECK(longest_line(r.out) <= 100);
    }
}

TEST_CASE("A table leaves out what is wide, and its legend with it") {
    const Columns<int> columns = {
        {"", "plain", 6, [](int i) { return std::to_string(i); }},
        {"contra-", "dicted", 8, [](int) { return "."; }, "said otherwise"},
        {"t, in", "ulp", 7, [](int) { return "2"; }, "an error", Detail::wide},
    };
    CHECK(heading("a ", columns, Detail::narrow) == "         contra-\na  plain  dicted\n");
    CHECK(heading("a ", columns, Detail::wide) ==
          "         contra-  t, in\na  plain  dicted    ulp\n");
    CHECK(line_of("b ", 5, columns, Detail::narrow) == "b      5       .\n");
    Legend narrow, wide;
    explain(columns, Detail::narrow, narrow);
    explain(columns, Detail::wide, wide);
    explain(columns, Detail::wide, wide);
    CHECK(narrow.text() == "  contradicted  said otherwise\n");
    CHECK(wide.text() == "  contradicted  said otherwise\n  t, in ulp     an error\n");
}
