// Damaged files of every format: any damage must give a valid scene or an error, at a cost in
// proportion to the file.
#include <algorithm>

#include "core/formats/write/write.h"
#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/formats/messages.h"
#include "tests/formats/sane_scene.h"
#include "tests/formats/whole_scenes.h"

using namespace etalon;

namespace {

/// Returns `text` as a damaged file.
void check_survives(const WholeScene& scene, const std::string& text) {
    CAPTURE(scene.format, text);
    const LoadResult r = load_text(scene.format, text);
    CHECK(r.diagnostics.size() <= 200);
    for (const Diagnostic& d : r.diagnostics) {
        CHECK((text.empty() || d.line >= 1));
        CHECK((text.empty() || d.column >= 1));
        CHECK_FALSE(d.message.empty());
    }
    if (r.scene) {
        CHECK(insanity(r) == "");
        CHECK(memory_bytes(*r.scene) < 4096 + scene.bytes_of_a_byte * text.size());
    } else {
        CHECK_FALSE(r.diagnostics.empty());
    }
}

}  // namespace

TEST_CASE("the scenes to be damaged are whole") {
    for (const WholeScene& scene : whole_scenes()) {
        const LoadResult r = load_text(scene.format, scene.text);
        CAPTURE(scene.format, messages(r));
        REQUIRE(r.scene);
        CHECK(r.diagnostics.size() == scene.diagnostics);
        CHECK(insanity(r) == "");
        CHECK(r.scene->geometry.primitives.size() == scene.primitives);
    }
}

TEST_CASE("a scene cut anywhere gives a scene or an error") {
    Random random(1);
    for (const WholeScene& scene : whole_scenes()) {
        for (int i = 0; i < 100; ++i) {
            check_survives(scene, scene.text.substr(0, random.index(scene.text.size())));
        }
    }
}

TEST_CASE("a scene with any byte flipped gives a scene or an error") {
    Random random(2);
    for (const WholeScene& scene : whole_scenes()) {
        for (int i = 0; i < 1000; ++i) {
            std::string damaged = scene.text;
            damaged[random.index(damaged.size())] ^= static_cast<char>(1U << random.index(8));
            check_survives(scene, damaged);
        }
    }
}

TEST_CASE("the valid rest of a damaged scene can be written and read again") {
    Random random(6);
    for (const WholeScene& scene : whole_scenes()) {
        for (int i = 0; i < 50; ++i) {
            std::string damaged = scene.text.substr(0, scene.text.size() * (i % 2 + 1) / 4);
            damaged[random.index(damaged.size())] ^= static_cast<char>(1U << random.index(8));
            CAPTURE(scene.format, damaged);
            const LoadResult r = load_text(scene.format, damaged);
            if (!r.scene) continue;
            CHECK(write_pbrt(*r.scene, r.settings, "").text.ends_with("WorldEnd\n"));
            const LoadResult again = load_text("p3f", write_p3f(*r.scene, r.settings, "").text);
            REQUIRE(again.scene);
            CHECK(insanity(again) == "");
        }
    }
}

TEST_CASE("a scene with many bytes of chance gives a scene or an error") {
    Random random(4);
    for (const WholeScene& scene : whole_scenes()) {
        for (int i = 0; i < 300; ++i) {
            std::string damaged = scene.text;
            for (int k = 0; k < 100; ++k) {
                damaged[random.index(damaged.size())] = static_cast<char>(random.bits());
            }
            check_survives(scene, damaged);
        }
    }
}

TEST_CASE("keywords of a format in any order give a scene or an error") {
    Random random(5);
    for (const WholeScene& scene : whole_scenes()) {
        for (int i = 0; i < 2000; ++i) {
            std::string text = i % 2 == 0 ? scene.camera : "";
            for (int k = 0; k < 200; ++k)
                text += scene.words[random.index(scene.words.size())] + " ";
            check_survives(scene, text);
        }
    }
}

TEST_CASE("a file of a million errors costs no more than its size") {
    for (const WholeScene& scene : whole_scenes()) {
        CAPTURE(scene.format);
        std::string text = scene.camera;
        for (int i = 0; i < 1000000; ++i) text += scene.bad_statement;
        const auto lines = std::count(scene.camera.begin(), scene.camera.end(), '\n');
        const LoadResult r = load_text(scene.format, text);
        REQUIRE(r.diagnostics.size() == 20);
        CHECK(r.diagnostics.back().more == 999980);
        CHECK(r.diagnostics.back().line == lines + 20);
    }
}

TEST_CASE("a million cameras cost no more than their size") {
    for (const WholeScene& scene : whole_scenes()) {
        CAPTURE(scene.format);
        std::string text;
        for (int i = 0; i < 1000000; ++i) text += scene.camera_keyword;
        const LoadResult r = load_text(scene.format, text);
        CHECK_FALSE(r.scene);
        CHECK(r.diagnostics.size() <= 21);
    }
}
