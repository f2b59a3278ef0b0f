// etalon crosscheck as a process: its figures add up, and its rays can be traced again.
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/common/backends.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

/// Returns a scene with nothing behind the ball: errors at its outline take hits for misses.
std::string lone_ball() {
    std::string scene = small_scene;
    const std::size_t plane = scene.find("pl ");
    return scene.erase(plane, scene.find('\n', plane) + 1 - plane);
}

std::vector<std::string_view> exact_backends() {
    std::vector<std::string_view> names;
    for (const etalon::Backend& b : etalon::all_backends()) {
        if (b.exact) names.push_back(b.name);
    }
    return names;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// Returns a backend's hits from the comments in the list of rays, in the order of the rays.
struct Listed {
    std::string wrong, found, oracle;
};

std::vector<Listed> listed(const std::string& rays) {
    std::vector<Listed> list;
    for (const std::string& line : lines_of(rays)) {
        const std::size_t ray = line.find(" ray, "), found = line.find(": "),
                          oracle = line.find("; the oracle: ");
        if (line[0] != '#' || oracle == std::string::npos) continue;
        list.push_back({line.substr(ray + 6, found - ray - 6),
                        line.substr(found + 2, oracle - found - 2), line.substr(oracle + 14)});
    }
    return list;
}

/// Returns whether a line of etalon trace, which also has the normal, agrees with the list.
bool says(const std::string& line, const std::string& answer) {
    return line == answer || line.rfind(answer + " ", 0) == 0;
}

}  // namespace

TEST_CASE("crosscheck finds no difference among the exact backends", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon("crosscheck ball.p3f --rays 200 --json c.json");
    CHECK(r.status == 0);
    const std::vector<std::string_view> exact = exact_backends();
    REQUIRE(exact.size() >= 4);
    CHECK_THAT(r.out, ContainsSubstring(fmt::format("\n{}\n", fmt::join(exact, ", "))));
    const json j = json::parse(f.read("c.json"));
    for (const std::string_view backend : exact) {
        for (const char* kind : {"camera", "shadow", "bounce", "aimed"}) {
            INFO(backend << " " << kind);
            CHECK(j[backend][kind]["rays"] > 0);
            CHECK(j[backend][kind]["class_errors"] == 0);
            CHECK(j[backend][kind]["primitive_errors"] == 0);
            CHECK(j[backend][kind]["occlusion_errors"] == 0);
        }
    }
}

TEST_CASE("crosscheck lists wrong answers that trace gives again", "[app]") {
    const Folder f;
    f.write("ball.p3f", lone_ball());
    const auto r =
        f.etalon("crosscheck ball.p3f -b embree-builtin --rays 600 --worst 12 --rays-out rays.txt");
    CHECK(r.status == 0);  // it is not an exact backend
    const auto list = listed(f.read("rays.txt"));
    REQUIRE(list.size() == 12);
    CHECK_THAT(r.out, ContainsSubstring(f.read("rays.txt")));
    const auto builtin = lines_of(f.etalon("trace ball.p3f --rays rays.txt -b embree-builtin").out);
    const auto exact = lines_of(f.etalon("trace ball.p3f --rays rays.txt -b bvh").out);
    REQUIRE(builtin.size() == list.size());
    REQUIRE(exact.size() == list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        INFO(list[i].wrong << "; " << builtin[i]);
        CHECK(says(builtin[i], list[i].found));
        CHECK(builtin[i] != exact[i]);
        CHECK((exact[i] == "miss") == (list[i].oracle == "miss"));
    }
    CHECK((list[0].wrong == "hit not found" || list[0].wrong == "hit where there is none"));
}

TEST_CASE("crosscheck reports for pairs of backends which was right", "[app]") {
    const Folder f;
    f.write("ball.p3f", lone_ball());
    const auto r = f.etalon("crosscheck ball.p3f -b bvh,embree-builtin --rays 600 --json c.json");
    CHECK_THAT(r.out, ContainsSubstring("embree-builtin is wrong where bvh is right in ") &&
                          ContainsSubstring("never the other way round"));
    const json j = json::parse(f.read("c.json"));
    REQUIRE(j["contingency"].size() == 1);
    const json& c = j["contingency"][0];
    CHECK(c["a"] == "bvh");
    CHECK(c["b"] == "embree-builtin");
    const int only_bvh = c["only_a_right"],
              decided = int(j["bvh"]["rays"]) - int(j["bvh"]["undecidable"]);
    CHECK(only_bvh >= int(j["embree-builtin"]["class_errors"]));
    CHECK(only_bvh > 0);
    CHECK(int(c["both_right"]) + only_bvh == decided);
    CHECK(c["only_b_right"] == 0);
    CHECK(c["both_wrong"] == 0);
    CHECK(c["mcnemar"] == only_bvh);
}

TEST_CASE("crosscheck counts hits on the right primitive whose root is wrong", "[app]") {
    const Folder f;
    f.write("near.p3f",
            "camera eye 0 0 3.0000002 at 0 0 0 up 0 1 0 angle 60 hither 0 resolution 64 64 "
            "aperture 0 focal 1\n"
            "mat 1 0.2 0.1 0.6 1 1 1 0 30 0 1\ns 0 0 0 3\n");
    const auto r = f.etalon("crosscheck near.p3f -b bvh,embree-builtin --rays 100 --json c.json");
    const json j = json::parse(f.read("c.json")), camera = j["embree-builtin"]["camera"];
    CHECK(camera["t_errors"] == camera["rays"]);  // Embree sees the far side
    CHECK(j["contingency"][0]["only_a_right"] >= camera["rays"]);
    CHECK(j["bvh"]["t_errors"] == 0);
}

TEST_CASE("crosscheck writes only the requested output to standard output", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    CHECK(
        json::parse(f.etalon("crosscheck ball.p3f -b bvh --rays 20 --json -").out).contains("bvh"));
    const auto r = f.shell(
        "'" ETALON_BINARY_DIR
        "/bin/etalon' crosscheck ball.p3f -b bvh --rays 20 --rays-out - | '" ETALON_BINARY_DIR
        "/bin/etalon' trace ball.p3f --rays -");
    CHECK(r.status == 0);
    CHECK(lines_of(r.out).size() == 5);
}
