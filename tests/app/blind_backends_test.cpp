// The exit status by which crosscheck and accuracy report that an exact backend is wrong.
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

ProgramResult with_blind_backends(const Folder& f, const std::string& arguments) {
    return f.shell("exec '" ETALON_BINARY_DIR "/bin/blind_backends' " + arguments);
}

}  // namespace

TEST_CASE("crosscheck has status 1 if a backend that claims to be exact is wrong", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string command = "crosscheck ball.p3f --rays 100 -b ";
    for (const char* backends : {"bvh", "modest", "bvh,modest"}) {
        CAPTURE(backends);
        CHECK(with_blind_backends(f, command + backends).status == 0);
    }
    for (const char* backends : {"blind", "bvh,blind", "blind,bvh"}) {
        CAPTURE(backends);
        CHECK(with_blind_backends(f, command + backends).status == 1);
    }
}

TEST_CASE("crosscheck calls an exact backend wrong whose every t is wrong", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = with_blind_backends(
        f, "crosscheck ball.p3f --rays 100 -b far-sighted,bvh --json c.json --worst 1");
    CHECK(r.status == 1);
    CHECK_THAT(r.out, ContainsSubstring("# far-sighted: the worst rays\n"));
    CHECK_THAT(r.out, ContainsSubstring("far-sighted is wrong where bvh is right in "));
    const auto total = json::parse(f.read("c.json"))["far-sighted"];
    CHECK(total["t_errors"] > 0);
    CHECK(total["class_errors"] == 0);
    CHECK(total["occlusion_errors"] == 0);
}

TEST_CASE("accuracy has status 1 if a backend that claims to be exact is wrong", "[app]") {
    const Folder f;
    const std::string command = "accuracy --case SPH-1 --only-backends --rays 100 --backends ";
    for (const char* backends : {"bvh", "modest", "bvh,modest"}) {
        const auto r = with_blind_backends(f, command + backends);
        CAPTURE(backends, r.err);
        CHECK(r.status == 0);
        CHECK_THAT(r.out, !ContainsSubstring("rows with errors"));
    }
    for (const char* backends : {"blind", "bvh,blind", "blind,bvh", "far-sighted"}) {
        const auto r = with_blind_backends(f, command + backends);
        CAPTURE(backends, r.err);
        CHECK(r.status == 1);
        CHECK_THAT(r.out, ContainsSubstring("rows with errors that none of them may have"));
    }
}
