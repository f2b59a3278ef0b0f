// Provenance of results: version, commit, compiler and command.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/common/program_facts.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

void check_provenance(const json& j, const std::string& command) {
    CHECK(j["schema"] == 1);
    CHECK(j["version"].get<std::string>().find('.') != std::string::npos);
    CHECK_FALSE(j["commit"].get<std::string>().empty());
    CHECK(j["compiler"].get<std::string>().find_first_of("0123456789") != std::string::npos);
    CHECK_THAT(j["flags"].get<std::string>(), ContainsSubstring("-ffp-contract=off"));
    CHECK_THAT(j["command"].get<std::string>(), ContainsSubstring(command));
    CHECK_FALSE(j["embree"]["version"].get<std::string>().empty());
    CHECK(j["embree"]["compiled_version"].get<std::string>().find('.') != std::string::npos);
    CHECK_FALSE(j["machine"]["cpu"].get<std::string>().empty());
    CHECK(j["machine"]["cores"] >= 1);
    CHECK_FALSE(j["machine"]["isa"].get<std::string>().empty());
}

/// Finds the commit of a folder as the build does, and lists what it depends on in "depends".
std::string commit_of(const Folder& f, const std::string& folder) {
    const auto r = f.shell("cmake -DSOURCE=\"$PWD/" + folder +
                           "\" -DOUTPUT=commit -DDEPFILE=depends -P '" ETALON_SOURCE_DIR
                           "/cmake/EtalonCommit.cmake'");
    REQUIRE(r.status == 0);
    const std::string text = f.read("commit");
    const std::size_t begin = text.find('"') + 1;
    return text.substr(begin, text.find('"', begin) - begin);
}

}  // namespace

TEST_CASE("A program beside this one: given how this one was called, then it is called alike",
          "[app]") {
    const std::string here = std::filesystem::current_path().string();
    const auto sibling_of = [](std::string called) {
        char* argv[] = {called.data()};
        etalon::note_command_line(1, argv);
        return etalon::sibling_program("etalon");
    };
    CHECK(sibling_of("build/bin/etalon-bench") == "build/bin/etalon");
    CHECK(sibling_of(here + "/build/bin/etalon-bench") == "build/bin/etalon");
    CHECK(sibling_of("/opt/my bin/etalon-bench") == "'/opt/my bin/etalon'");
    CHECK(sibling_of("../etalon-bench") == "../etalon");
    CHECK(sibling_of("etalon-bench") == "etalon");
}

TEST_CASE("The commit is that of the tree's own repository, and says what differs",
          "[app][needs_git]") {
    const Folder f;
    SKIP_UNLESS(f.shell("git --version").status == 0, "git is not installed");
    const auto made = f.shell(
        "mkdir -p tree/tarball && cd tree && git init -q && echo 1 >'a b' && echo 1 >tarball/c && "
        "git add . && git -c user.name=a -c user.email=a@b.c commit -qm 1 && "
        "git worktree add -q ../other");
    REQUIRE(made.status == 0);
    const std::string commit = commit_of(f, "tree");
    CHECK(commit.size() == 12);
    CHECK_THAT(f.read("depends"), ContainsSubstring("/tree/a\\ b"));
    CHECK_THAT(f.read("depends"), ContainsSubstring("/tree/.git/HEAD"));
    CHECK(commit_of(f, "other") == commit);
    CHECK_THAT(f.read("depends"), ContainsSubstring("/tree/.git/worktrees/other/HEAD"));
    CHECK(commit_of(f, "tree/tarball") == "unknown");
    f.write("tree/a b", "22");
    CHECK(commit_of(f, "tree") == commit + "-dirty");
    CHECK(commit_of(f, "other") == commit);
}

TEST_CASE("the same render twice gives equal files", "[app]") {
    const Folder f;
    f.write("a.p3f", small_scene);
    for (const std::string name : {"x", "y"}) {
        const std::string outputs = " -o " + name + ".exr -o " + name + ".png";
        REQUIRE(f.etalon("render a.p3f --spp 2 -q" + outputs).status == 0);
    }
    CHECK(f.read("x.exr") == f.read("y.exr"));
    CHECK(f.read("x.png") == f.read("y.png"));
}

TEST_CASE("a PNG names its program and scene, as an EXR does", "[app]") {
    const Folder f;
    f.write("a.p3f", small_scene);
    REQUIRE(f.etalon("render a.p3f --spp 2 --seed 77 -q -o a.exr -o a.png").status == 0);
    for (const char* text : {"Etalon ", "scene", "a.p3f", "seed", "77", "samplesPerPixel"}) {
        INFO(text);
        CHECK_THAT(f.read("a.png"), ContainsSubstring(text));
        CHECK_THAT(f.read("a.exr"), ContainsSubstring(text));
    }
}

TEST_CASE("stats and measurements have the program's version and command line", "[app]") {
    const Folder f;
    f.write("a scene.p3f", small_scene);
    REQUIRE(f.etalon("render 'a scene.p3f' -q -o a.png --stats s.json").status == 0);
    check_provenance(json::parse(f.read("s.json")),
                     "etalon render 'a scene.p3f' -q -o a.png --stats s.json");
    REQUIRE(f.shell("exec '" ETALON_BINARY_DIR
                    "/bin/etalon-bench' frames 'a scene.p3f' --repeat 1 --json f.json")
                .status == 0);
    check_provenance(json::parse(f.read("f.json")),
                     "etalon-bench frames 'a scene.p3f' --repeat 1 --json f.json");
    REQUIRE(f.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' accuracy --case SPH-1 --rays 10 "
                    "--only-backends --json a.json")
                .status == 0);
    check_provenance(json::parse(f.read("a.json")), "etalon-bench accuracy --case SPH-1 --rays 10");
}

TEST_CASE("--version shows the commit, the compiler, Embree and the instruction set", "[app]") {
    const Folder f;
    f.write("a.p3f", small_scene);
    const auto stats = json::parse(f.etalon("render a.p3f -q -b bvh -o a.png --stats -").out);
    const std::string isa = stats["isa"];
    CHECK(stats["machine"]["isa"] == isa);
    for (const std::string program : {"etalon", "etalon-bench", "etalon-scenes"}) {
        const auto r = f.shell("exec '" ETALON_BINARY_DIR "/bin/" + program + "' --version");
        INFO(r.out << r.err);
        CHECK(r.status == 0);
        CHECK_THAT(r.out, ContainsSubstring(program + " ") && ContainsSubstring("\ncommit ") &&
                              ContainsSubstring("\ncompiler ") && ContainsSubstring("\nflags "));
        if (program == "etalon-scenes") continue;  // it has neither
        CHECK_THAT(r.out, ContainsSubstring("\nembree ") && ContainsSubstring(", compiled for "));
        CHECK_THAT(r.out, ContainsSubstring("\ninstruction set " + isa));
    }
}

TEST_CASE("A name that is not UTF-8 is UTF-8 in the files that have it", "[app]") {
    const Folder f;
    f.write("caf\xe9.p3f", small_scene);
    REQUIRE(f.etalon("render caf*.p3f -q -o a.png -o a.exr").status == 0);
    for (const char* file : {"a.png", "a.exr"}) {
        CHECK_THAT(f.read(file), ContainsSubstring("caf\xef\xbf\xbd.p3f"));
    }
}
