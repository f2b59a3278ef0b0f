// etalon-bench accuracy as a process: which cases it measures.
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

ProgramResult accuracy(const Folder& folder, const std::string& arguments) {
    return folder.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' accuracy " + arguments);
}

}  // namespace

TEST_CASE("accuracy: given a backend without kernels for a case, then it says so and goes on") {
    const Folder f;
    const auto r = accuracy(f,
                            "--case SPN-1,CYL-5,SPH-1 --rays 50 --backends embree-builtin "
                            "--only-backends --json a.json");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("none of the backends has kernels of its own for it"));
    const json rows = json::parse(f.read("a.json"))["rows"];
    REQUIRE_FALSE(rows.empty());
    for (const json& row : rows) CHECK(row["id"] == "SPH-1");
}

TEST_CASE("accuracy: given other backends, then the spawned rays are the same") {
    const Folder f;
    const auto rays_of_builtin = [&](const std::string& backends) {
        const std::string command =
            "--case SPN-4 --rays 500 --only-backends --json a.json --backends ";
        REQUIRE(accuracy(f, command + backends).status == 0);
        const json rows = json::parse(f.read("a.json"))["rows"];
        std::string rays;
        for (const json& row : rows) {
            if (row["tracer"] == "embree-builtin") rays += row["rays"].dump() + " ";
        }
        return rays;
    };
    CHECK(rays_of_builtin("embree-builtin") == rays_of_builtin("bvh,embree-builtin"));
}

TEST_CASE("accuracy: given a name that no case has, then it is an error that quotes it") {
    const Folder f;
    for (const char* cases : {"SPH-1,TYPO-9", "TYPO-9,SPH-1", "SPH-1/nothing --list"}) {
        CAPTURE(cases);
        const auto r = accuracy(f, std::string("--rays 10 --backends bvh --case ") + cases);
        CHECK(r.status == 2);
        CHECK(r.out.empty());
        CHECK_THAT(r.err, ContainsSubstring("no case of that name"));
    }
}

TEST_CASE("accuracy: given the names of --list, then each names its case, with its commas") {
    const Folder f;
    const std::string all = accuracy(f, "--list").out;
    REQUIRE_THAT(all, ContainsSubstring("\nSPH-1/1e3 radii, float\n"));
    CHECK(accuracy(f, "--list --case 'SPH-1/1e3 radii, float'").out == "SPH-1/1e3 radii, float\n");
    CHECK(accuracy(f, "--list --case 'SPH-1/1e3 radii, float,SPN-4/sliver'").out ==
          "SPH-1/1e3 radii, float\nSPN-4/sliver\n");
    CHECK_THAT(accuracy(f, "--list --case 'SPH-1/1e3 radii'").out,
               ContainsSubstring("SPH-1/1e3 radii\n") && ContainsSubstring("radii, float\n"));
}
