// Damaged files: whatever the damage, a sane scene or an error, at a cost in proportion to the
// file.
#include <random>

#include "tests/catch.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/sane_scene.h"

using namespace etalon;

namespace {

/// A scene with every kind of statement, comments, and both dialects.
std::string scene_text() {
    std::string text =
        "# generated\r\naccel grid\nspp 4\nbclr 0.1 0.2 0.3\nenv nosky\n" + good_camera;
    text += "light punctual 1 2 3 1 1 1\nlight quad 4 3 2 1 1 1 4 2 2 3 3 2 16\nl 9 9 9 .5 .5 .5\n";
    text += good_material + "pl 12 12 -0.5 -12 12 -0.5 -12 -12 -0.5\nnpl 0 0 1 3 #floor\n";
    text +=
        "f 0 0.5 0 0 1 1 1 0.2 30.1 1 1.15\nbox 0 0 0 1 1 1.5\nc 1 2 3 0.5\n3 2 1 0\ns 0 0 0 -9\n";
    text += "p 5\n0 0 0\n1 0 0\n1 1 0\n.5 .25 0\n0 1 0\n";
    text += "pp 3\n0 0 0 0 0 1\n1 0 0 0 0.1 1\n0 1 0 0.1 0 1\n";
    std::mt19937 random(3);
    for (int i = 0; i < 60; ++i) {
        text += "s " + std::to_string(static_cast<double>(random() % 1000) * 1e-3) +
                " -1.5e-2 +7. .25\n";
    }
    text += "mesh 40 60\n";
    for (int i = 0; i < 40; ++i) {
        for (int k = 0; k < 3; ++k)
            text += std::to_string(static_cast<double>(random() % 999) * 1e-2) + " ";
        text += "\n";
    }
    for (int i = 0; i < 60; ++i) {
        const auto v = random() % 38;
        text +=
            std::to_string(v + 1) + " " + std::to_string(v + 2) + " -" + std::to_string(1) + "\n";
    }
    return text;
}

/// `text` as a file that came to harm.
void check_survives(const std::string& text) {
    CAPTURE(text);
    const LoadResult r = load_p3f_text(text);
    CHECK(r.diagnostics.size() <= 200);
    for (const Diagnostic& d : r.diagnostics) {
        CHECK(d.line >= 1);
        CHECK(d.column >= 1);
        CHECK_FALSE(d.message.empty());
    }
    if (r.scene) {
        CHECK(insanity(*r.scene) == "");
        CHECK(memory_bytes(*r.scene) < 4096 + 40 * text.size());
    } else {
        CHECK_FALSE(r.diagnostics.empty());
    }
}

}  // namespace

TEST_CASE("the scene to be damaged is whole") {
    const LoadResult r = load_p3f_text(scene_text());
    REQUIRE(r.scene);
    CHECK(r.diagnostics.size() == 1);  // its skybox does not exist
    CHECK(insanity(*r.scene) == "");
    CHECK(r.scene->primitives.size() == 127);
}

TEST_CASE("a scene cut anywhere gives a scene or an error") {
    const std::string text = scene_text();
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) check_survives(text.substr(0, random() % text.size()));
}

TEST_CASE("a scene with any byte flipped gives a scene or an error") {
    const std::string text = scene_text();
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        std::string damaged = text;
        damaged[random() % text.size()] ^= static_cast<char>(1U << (random() % 8));
        check_survives(damaged);
    }
}

TEST_CASE("a scene with many bytes of chance gives a scene or an error") {
    const std::string text = scene_text();
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        std::string damaged = text;
        for (int k = 0; k < 100; ++k) damaged[random() % text.size()] = static_cast<char>(random());
        check_survives(damaged);
    }
}

TEST_CASE("words of the format in any order give a scene or an error") {
    const char* const words[] = {
        "s",        "p",     "pp",         "mat", "f",   "box",   "c",     "mesh",   "pl",
        "npl",      "light", "l",          "v",   "env", "accel", "spp",   "eye",    "at",
        "quad",     "0",     "1",          "-1",  "3",   "4",     "1e308", "-1e308", "1e-308",
        "punctual", "angle", "resolution", "up",  "2",   "sm",    "\n",    "#\n",    "camera"};
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
        std::string text = i % 2 == 0 ? good_camera : "";
        for (int k = 0; k < 200; ++k) text += std::string(words[random() % std::size(words)]) + " ";
        check_survives(text);
    }
}

TEST_CASE("a file of a million errors costs no more than its size") {
    std::string text = good_camera;
    for (int i = 0; i < 1000000; ++i) text += "s x\n";
    const LoadResult r = load_p3f_text(text);
    REQUIRE(r.diagnostics.size() == 20);
    CHECK(r.diagnostics.back().more == 999980);
    CHECK(r.diagnostics.back().line == 29);
}

TEST_CASE("a million cameras cost no more than their size") {
    std::string text;
    for (int i = 0; i < 1000000; ++i) text += "v ";
    const LoadResult r = load_p3f_text(text);
    CHECK_FALSE(r.scene);
    CHECK(r.diagnostics.size() <= 21);
}
