// Tables of other programs' images: the reader, and the program as a process.
#include "bench/convergence/foreign_table.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::convergence;
using namespace etalon::test;

using nlohmann::json;

namespace {

etalon::Result<std::vector<ForeignImage>> table_in(const Folder& f, const std::string& text) {
    f.write("other.tsv", text);
    return read_foreign_table(f.path("other.tsv"));
}

/// Folder with a scene, its reference, an image of few samples, and a grey one as PFM.
struct ForeignFolder : Folder {
    ForeignFolder() {
        write("ball.p3f", small_scene);
        REQUIRE(etalon("render ball.p3f --spp 256 --seed 7 -q -o ball-256.exr").status == 0);
        REQUIRE(etalon("render ball.p3f --spp 2 --seed 9 -q -o few.exr").status == 0);
        std::string grey = "PF\n32 24\n-1.0\n";
        for (int i = 0; i < 3 * 32 * 24; ++i) grey.append({0, 0, 0, 0x3f});
        write("grey.pfm", grey);
    }
    auto convergence(const std::string& arguments) const {
        return shell("exec '" ETALON_BINARY_DIR
                     "/bin/etalon-bench' convergence ball.p3f --spp 16 "
                     "--seeds 2 --samplers sobol " +
                     arguments);
    }
};

}  // namespace

TEST_CASE("A table has the columns that its heading names, in any order") {
    const Folder f;
    const auto table = table_in(f,
                                "# a comment\n\nspp\tcpu_s\timage\tscene\trelmse\n"
                                "16\t1.5\ta b.pfm\tx/a.pbrt\t-\r\n\t2e1\t\tx/a.pbrt\t0.25\n");
    CHECK(table.error.empty());
    REQUIRE(table.value.size() == 2);
    const ForeignImage &measured = table.value[0], &told = table.value[1];
    CHECK(measured.program == "other");
    CHECK(measured.image == f.path("a b.pfm"));
    CHECK(measured.scene == f.path("x/a.pbrt"));
    CHECK(measured.samples == 16);
    CHECK(measured.cpu_seconds == 1.5);
    CHECK(std::isnan(measured.relmse));
    CHECK(told.image.empty());
    CHECK(told.samples == 0);
    CHECK(told.cpu_seconds == 20);
    CHECK(told.relmse == 0.25);
    CHECK(scenes_of(table.value) == std::vector<std::string>{f.path("x/a.pbrt")});
}

TEST_CASE("The reference beside a scene is the image with the most samples") {
    const Folder f;
    for (const char* name : {"s-4", "s-1024", "s-0256", "s-x2048", "s-", "s-0", "t-4096"}) {
        f.write(name + std::string(".exr"), "");
        const std::string reference = reference_for({}, f.path("s.pbrt"));
        CHECK(reference == f.path(name == std::string("s-4") ? "s-4.exr" : "s-1024.exr"));
    }
    f.write("s-00010000000000000000000000.exr", "");
    CHECK(reference_for({}, f.path("s.pbrt")) == f.path("s-00010000000000000000000000.exr"));
    CHECK(reference_for({}, f.path("none.pbrt")).empty());
}

TEST_CASE("A table may begin with a byte order mark") {
    const Folder f;
    const auto table = table_in(f, "\xEF\xBB\xBFwidth\tcpu_s\trelmse\n60\t1\t0.25\n");
    CHECK(table.error.empty());
    REQUIRE(table.value.size() == 1);
    CHECK(table.value[0].size.x == 60);
}

TEST_CASE("What is wrong with a table is said with line and column") {
    const Folder f;
    const auto error = [&](const std::string& text) {
        return table_in(f, text).error.substr(f.path("other.tsv").size());
    };
    CHECK_THAT(error("cpu_s\tcolour\n"), ContainsSubstring(":1:7: error: column \"colour\""));
    CHECK_THAT(error("cpu_s\trelmse\n1\t0.1\n1\n"), ContainsSubstring(":3:1: error: 1 fields"));
    for (const std::string wrong : {"0", "-1", "nan", "inf", "1e999", "1x", "x"}) {
        INFO(wrong);
        CHECK_THAT(error("relmse\tcpu_s\n0.1\t" + wrong + "\n"),
                   ContainsSubstring(":2:5: error: \"" + wrong + "\"; expected a number above 0"));
    }
    CHECK_THAT(error("relmse\tcpu_s\n0.1\t-\n"), ContainsSubstring(":2:1: error: no cpu_s"));
    CHECK_THAT(error("cpu_s\n1\n"), ContainsSubstring("either an image or its relmse"));
    CHECK_THAT(error("cpu_s\timage\trelmse\n1\ta\t1\n"), ContainsSubstring("either an image"));
    CHECK_THAT(error("cpu_s\trelmse\tcpu_s\n"),
               ContainsSubstring(":1:14: error: column \"cpu_s\" is there twice"));
    for (const std::string wrong : {"0", "-1", "60.7", "1e2", "99999999999"}) {
        INFO(wrong);
        CHECK_THAT(error("width\tcpu_s\n" + wrong + "\t1\n"),
                   ContainsSubstring("expected a number of pixels"));
    }
    CHECK_THAT(error("cpu_s\trelmse\n"), ContainsSubstring("no images in it"));
    CHECK_THAT(error(""), ContainsSubstring("no images in it"));
    for (const char* path : {"none.tsv", "."}) {
        CHECK_THAT(read_foreign_table(f.path(path)).error,
                   ContainsSubstring(": error: cannot be read"));
    }
}

TEST_CASE("convergence measures other programs' images as compare does", "[app]") {
    const ForeignFolder f;
    f.write("t.tsv",
            "program\tscene\timage\tspp\tcpu_s\trelmse\n"
            "A\tball.p3f\tfew.exr\t2\t5\t-\nA\tball.p3f\tgrey.pfm\t1\t9\t-\nA\tball.p3f\t-\t-"
            "\t500\t1e-9\n"
            "B\t-\t-\t-\t7\t0.02\nA\tother.p3f\tnone.exr\t1\t1\t-\n");
    const auto r = f.convergence("--foreign t.tsv --json c.json --csv c.csv");
    INFO(r.err);
    REQUIRE(r.status == 0);
    REQUIRE(f.etalon("compare few.exr ball-256.exr --json m.json").status == 0);
    REQUIRE(f.etalon("compare grey.pfm ball-256.exr --json g.json").status == 0);
    const json c = json::parse(f.read("c.json")), m = json::parse(f.read("m.json"));
    CHECK_THAT(c["reference"].get<std::string>(), ContainsSubstring("ball-256.exr"));
    REQUIRE(c["foreign"].size() == 2);
    const json& point = c["foreign"][0]["points"][0];
    CHECK(point["relmse"] == m["relmse"]);
    CHECK(point["mse"] == m["mse"]);
    CHECK(c["foreign"][0]["points"][1]["relmse"] == json::parse(f.read("g.json"))["relmse"]);
    const double mean_a = m["mean_a"][0], mean_b = m["mean_b"][0];
    CHECK(point["mean_difference"][0].get<double>() == Approx(mean_a / mean_b - 1));
    CHECK(point["efficiency"].get<double>() == Approx(1 / (5 * m["relmse"].get<double>())));
    REQUIRE(c["comparisons"].size() == 2);
    const json& beside = c["comparisons"][0];
    CHECK(beside["program"] == "A");
    CHECK(beside["points"][0]["extrapolated"] == false);
    CHECK(beside["points"][2]["extrapolated"] == true);
    CHECK(beside["points"][0]["ratio"].get<double>() ==
          Approx(5 / beside["points"][0]["cpu_seconds"].get<double>()));
    CHECK_THAT(r.out, ContainsSubstring("extrapolated") && ContainsSubstring("A beside whitted"));
    const std::string csv = f.read("c.csv");
    CHECK(std::ranges::count(csv, '\n') == 1 + 5 + 4);  // heading, our passes, theirs
    CHECK_THAT(csv, ContainsSubstring("\"whitted, sobol, bvh\",1,"));
}

TEST_CASE("A table whose images are not those of the scene is refused", "[app]") {
    const ForeignFolder f;
    std::string black = "PF\n1 1\n-1.0\n";
    f.write("black.pfm", black.append(12, '\0'));
    const auto refused = [&](const std::string& table, const std::string& why) {
        f.write("t.tsv", table);
        const auto r = f.convergence("--foreign t.tsv --json c.json");
        INFO(r.err);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring(why));
        CHECK_FALSE(f.has("c.json"));
    };
    refused("cpu_s\timage\n1\tnone.exr\n", "t.tsv:2: error: ");
    refused("cpu_s\timage\n1\tblack.pfm\n", "1 x 1 pixels");
    refused("cpu_s\trelmse\twidth\n1\t0.1\t33\n", "expected 32 x 24");
    refused("cpu_s\trelmse\tscene\n1\t0.1\tother.p3f\n", "no image of ball.p3f");
    refused("spp\n1\n", "no cpu_s");
    f.write("t.tsv", "cpu_s\trelmse\n1\t0.1\n");
    REQUIRE(f.shell("rm ball-256.exr").status == 0);
    CHECK_THAT(f.convergence("--foreign t.tsv").err, ContainsSubstring("no reference of ball.p3f"));
    CHECK(f.convergence("--foreign t.tsv --json - --csv -").status == 2);
}

TEST_CASE("The CSV of convergence has a line for images without an error, too", "[app]") {
    const ForeignFolder f;
    f.write("t.tsv",
            "program\timage\tspp\tcpu_s\n"
            "A\tfew.exr\t2\t5\nA\tball-256.exr\t256\t9\nperfect\tball-256.exr\t256\t7\n");
    REQUIRE(f.convergence("--foreign t.tsv --csv c.csv").status == 0);
    const std::string csv = f.read("c.csv");
    CHECK_THAT(csv, ContainsSubstring("A,2,5,"));
    CHECK_THAT(csv, ContainsSubstring("A,256,9,0,0,,"));
    CHECK_THAT(csv, ContainsSubstring("perfect,256,7,0,0,,"));
    CHECK(std::ranges::count(csv, '\n') == 1 + 5 + 3);
}

TEST_CASE("convergence keeps what is done when it is interrupted", "[app]") {
    const ForeignFolder f;
    f.write("t.tsv", "cpu_s\timage\n1\tfew.exr\n");
    const auto r = interrupted(f,
                               "etalon-bench convergence ball.p3f --foreign t.tsv --spp 65536 "
                               "--seeds 1000 --json c.json --csv c.csv",
                               has_worked(20));
    CHECK(r.status == 130);
    const json c = json::parse(f.read("c.json"));
    CHECK(c["stopped"] == "signal");
    CHECK(c["foreign"][0]["points"].size() == 1);
    CHECK(c["curves"].empty());
    CHECK_THAT(f.read("c.csv"), ContainsSubstring("t,,1,"));
}
