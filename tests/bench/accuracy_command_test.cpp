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
        std::string rays;
        for (const json& row : json::parse(f.read("a.json"))["rows"]) {
            if (row["tracer"] == "embree-builtin") rays += row["rays"].dump() + " ";
        }
        return rays;
    };
    CHECK(rays_of_builtin("embree-builtin") == rays_of_builtin("bvh,embree-builtin"));
}
