// Help texts of the programs, and their messages about wrong command lines.
#include <algorithm>
#include <sstream>
#include <tuple>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

struct Program {
    std::string name;
    std::vector<std::string> commands;
};

const std::vector<Program> programs = {
    {"etalon", {"render", "serve", "info", "trace", "crosscheck", "compare", "convert", "merge"}},
    {"etalon-bench", {"speed", "accuracy", "convergence", "frames", "report"}},
    {"etalon-scenes", {""}},
};

ProgramResult run(const Folder& f, const std::string& command_line) {
    return f.shell("PATH=" ETALON_BINARY_DIR "/bin:$PATH; " + command_line);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Returns the words of a text, separated by single spaces.
std::string words_of(const std::string& text) {
    std::string words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words += (words.empty() ? "" : " ") + word;
    return words;
}

/// Returns the command lines below "Examples:".
std::vector<std::string> examples_in(const std::string& help) {
    std::vector<std::string> examples;
    for (const std::string& line : lines_of(help.substr(help.find("\nExamples:\n") + 1))) {
        if (line.starts_with("  etalon")) examples.push_back(line.substr(2));
    }
    return examples;
}

/// A folder with the files that the examples name.
void put_inputs(const Folder& f) {
    f.write("scene.p3f", small_scene);
    f.write("rays.txt", "0 0 5 0 0 -1\n");
    CHECK(f.etalon("render scene.p3f -q -o a.exr").status == 0);
    CHECK(f.etalon("render scene.p3f --seed 1 --spp 1 -q -o b.exr").status == 0);
    for (const char* part : {"--part 1/2 -o part1.exr", "--part 2/2 -o part2.exr"}) {
        CHECK(f.etalon(std::string("render scene.p3f --spp 2 -q ") + part).status == 0);
    }
    for (const char* crop : {"0,0,9,24 -o left.exr", "9,0,32,24 -o right.exr"}) {
        CHECK(
            f.etalon(std::string("render scene.p3f --spp 1 --part 1/1 -q --crop ") + crop).status ==
            0);
    }
}

std::string error_of(const Folder& f, const std::string& command_line) {
    const auto r = run(f, command_line);
    INFO(command_line);
    CHECK(r.status == 2);
    CHECK(r.out == "");
    return r.err.substr(0, r.err.find('\n'));
}

}  // namespace

TEST_CASE("help names each value by its kind and fits 80 columns", "[app]") {
    const Folder f;
    for (const Program& program : programs) {
        for (const std::string& command : program.commands) {
            INFO(program.name << " " << command);
            const auto r = run(f, program.name + " " + command + " --help");
            CHECK(r.status == 0);
            CHECK(r.err == "");
            for (const char* type : {"TEXT", "INT", "FLOAT", "UINT", ":POSITIVE"}) {
                CHECK_THAT(r.out, !ContainsSubstring(type));
            }
            const std::size_t footer = r.out.find("\nExamples:\n");
            REQUIRE(footer != std::string::npos);
            for (const std::string& line : lines_of(r.out.substr(0, footer))) {
                INFO(line);
                CHECK(line.size() <= 80);
            }
            CHECK(examples_in(r.out).size() == 2);
        }
    }
    const auto render = run(f, "etalon render --help").out;
    for (const char* shown : {"--output FILE", "--resolution WxH", "--time-limit SECONDS"}) {
        CHECK_THAT(render, ContainsSubstring(shown));
    }
}

TEST_CASE("help marks optional arguments", "[app]") {
    const Folder f;
    const auto usage = [&](const std::string& command) {
        return lines_of(run(f, command + " --help").out).front();
    };
    CHECK(usage("etalon render") == "Usage: etalon render [OPTIONS] SCENE");
    CHECK(usage("etalon-bench frames") == "Usage: etalon-bench frames [OPTIONS] SCENE...");
    CHECK(usage("etalon-bench report") == "Usage: etalon-bench report [OPTIONS] [SCENE...]");
}

TEST_CASE("help gives the same range of a number as the error message", "[app]") {
    const Folder f;
    const std::tuple<std::string, std::string, std::string> cases[] = {
        {"etalon render s.p3f --spp -1", "from 0 to 16777216", "0 to 16777216"},
        {"etalon render s.p3f --threads 0", "from 1 to 4096", "1 to 4096"},
        {"etalon render s.p3f --time-limit 0", "a number above 0", "Above 0"},
        {"etalon crosscheck s.p3f --rays 0", "from 1 to 16777216", "1 to 16777216"},
        {"etalon-bench accuracy --rays 0", "from 1 to 1000000000000", "1 to 1000000000000"},
        {"etalon-bench speed --oracle -1", "0 or a number above", "0 or above"}};
    for (const auto& [command, error, shown] : cases) {
        CHECK_THAT(error_of(f, command), ContainsSubstring(error));
        const std::string name = command.substr(command.find("--"));
        const std::string option = name.substr(0, name.find(' '));
        const std::string to_command = command.substr(0, command.find(' ', command.find(' ') + 1));
        const std::string help = run(f, to_command + " --help").out;
        const std::size_t at = help.find(option + " ");
        REQUIRE(at != std::string::npos);
        const std::string entry = help.substr(at, help.find("\n  -", at) - at);
        CHECK_THAT(words_of(entry), ContainsSubstring(shown));
    }
}

TEST_CASE("the examples in the help of etalon and etalon-scenes run", "[app]") {
    for (const std::string program : {"etalon", "etalon-scenes"}) {
        const auto& commands = program == "etalon" ? programs[0].commands : programs[2].commands;
        for (const std::string& command : commands) {
            const Folder f;
            put_inputs(f);
            for (const auto& example :
                 examples_in(run(f, program + " " + command + " --help").out)) {
                INFO(example);
                const auto r = run(f, example);
                INFO(r.err);
                CHECK(r.status == 0);
            }
        }
    }
}

TEST_CASE("the examples in the help of etalon-bench are valid command lines", "[app]") {
    const Folder f;
    put_inputs(f);
    // Outputs that cannot be written are reported before anything is measured.
    f.shell("mkdir speed.json accuracy.json convergence.json frames.json; touch report results");
    for (const std::string& command : programs[1].commands) {
        for (const auto& example : examples_in(run(f, "etalon-bench " + command + " --help").out)) {
            INFO(example);
            const auto r = run(f, example);
            INFO(r.err);
            CHECK(r.status == (example.ends_with("--list") ? 0 : 4));
        }
    }
}

TEST_CASE("a misspelt command or option is answered with the nearest name", "[app]") {
    const Folder f;
    CHECK(error_of(f, "etalon rendr") ==
          "etalon: error: no command 'rendr'; did you mean 'render'?");
    CHECK(error_of(f, "etalon-bench sped --json a") ==
          "etalon-bench: error: no command 'sped'; did you mean 'speed'?");
    CHECK_THAT(error_of(f, "etalon render --="), ContainsSubstring("no option --"));
    CHECK_THAT(error_of(f, "etalon paint"), ContainsSubstring("'paint'; expected render, serve, "));
    CHECK_THAT(error_of(f, "etalon"), ContainsSubstring("no command given; expected render"));
    for (const char* line : {"etalon render a.p3f --ssp 4", "etalon render --ssp 4 a.p3f",
                             "etalon render a.p3f --ssp=4", "etalon render --ssp"}) {
        CHECK(error_of(f, line) == "etalon: error: no option --ssp; did you mean --spp?");
    }
    CHECK(error_of(f, "etalon render -spp 4 a.p3f") ==
          "etalon: error: no option -spp; did you mean --spp?");
    CHECK(error_of(f, "etalon-scenes tetra --sise 2") ==
          "etalon-scenes: error: no option --sise; did you mean --size?");
    CHECK(error_of(f, "etalon render a.p3f --frobnicate") ==
          "etalon: error: no option --frobnicate");
    CHECK(error_of(f, "etalon render a.p3f b.p3f") == "etalon: error: unexpected argument 'b.p3f'");
    CHECK(error_of(f, "etalon convert -- a.p3f -o b.p3f") ==
          "etalon: error: unexpected argument 'b.p3f'");
}

TEST_CASE("a wrong value is reported with what was expected", "[app]") {
    const Folder f;
    const std::pair<std::string, std::string> cases[] = {
        {"--target-error 0", "--target-error 0: expected a number above 0"},
        {"--spp many", "--spp many: expected a whole number from 0 to 16777216"},
        {"--spp -1", "--spp -1: expected a whole number from 0 to 16777216"},
        {"--spp 99999999999", "--spp 99999999999: expected a whole number from 0 to 16777216"},
        {"--seed 18446744073709551616",
         "--seed 18446744073709551616: expected a whole number from 0 to 18446744073709551615"},
        {"--seed -1", "--seed -1: expected a whole number from 0 to 18446744073709551615"},
        {"--spp", "--spp: expected a value"},
        {"--spp 1 --spp 2", "--spp: given more than once"},
        {"--exposure nan", "--exposure nan: expected a number"},
        {"--output a.gif", "--output a.gif: expected a name ending in .exr or .png, or -"},
        {"--aov albdo",
         "--aov albdo: expected one of albedo, N, P, Z, uv, dpdu, dpdv, primitiveId, instanceId, "
         "variance, "
         "sampleCount, cost.boxTests, cost.primitiveTests; did you mean 'albedo'?"},
        {"--sampler sobel",
         "--sampler sobel: expected one of sobol, random; did you mean 'sobol'?"}};
    for (const auto& [option, error] : cases) {
        CHECK(error_of(f, "etalon render a.p3f " + option) == "etalon: error: " + error);
    }
}

TEST_CASE("a list is one argument: the scene after it is not taken for an entry", "[app]") {
    const Folder f;
    f.write("G", small_scene);
    CHECK(f.etalon("render --aov albedo,N G -q -o a.exr").status == 0);
    CHECK(f.etalon("render --aov albedo --aov N G -q -o a.exr").status == 0);
    CHECK(error_of(f, "etalon render --aov albedo N G") ==
          "etalon: error: unexpected argument 'G'");
}
