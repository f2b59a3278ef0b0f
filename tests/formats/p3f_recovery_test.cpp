// Misplaced words in P3F: the reader reports each once and goes on at the next keyword.
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

TEST_CASE("comments and line ends stand anywhere") {
    const LoadResult r = load_objects(
        "#a comment\r\n##s 1 1 1 1\r\ns 0 #x\r\n1.5# y\r\n\t2 # z\r\n0.5 #main sphere\r\n#\r\n");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Sphere>().size() == 1);
    CHECK(r.scene->geometry.all<Sphere>()[0].centre == Vec3(0, 1.5, 2));
}

TEST_CASE("a comment may stand inside the camera and at the end without a line end") {
    std::string text = good_camera;
    text.insert(text.find("at"), "# from here\n");
    CHECK(messages(load_p3f_text(text + "#end")).empty());
}

TEST_CASE("an unknown keyword is reported once, with the nearest known one") {
    const LoadResult r = load_objects("sphere 0 0 0 1\nMESH 1 2 3\ns 0 0 0 1\nbox1 0 0 0 1 1 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:2:1: warning: unknown keyword 'sphere' (words skipped: 9)",
                   "a.p3f:5:1: warning: unknown keyword 'box1' (words skipped: 7); did you "
                   "mean 'box'?"});
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("stray numbers after a statement are one warning") {
    const LoadResult r = load_statements("light punctual 5 10 1 1 1 1 0 0 0 0 0.5 16\n#x\n" +
                                         good_material + "s 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:1:29: warning: expected a keyword after 'light', found '0' (words "
                   "skipped: 6)"});
    CHECK(r.scene->whitted().lights.size() == 1);
    CHECK(r.scene->whitted().materials.size() == 1);
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("numbers at the start of a file are one warning") {
    CHECK(messages(load_p3f_text("1 2 3\n" + good_camera)) ==
          Messages{"a.p3f:1:1: warning: expected a keyword, found '1' (words skipped: 3)"});
}

TEST_CASE("a run of garbage after an error is no further warning") {
    std::string garbage;
    for (int i = 0; i < 10000; ++i) garbage += "?! 1 ";
    const LoadResult r = load_objects("s 0 0 x 1 " + garbage + "\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:2:7: warning: expected a number for the centre of 's', found 'x'"});
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("a statement that lacks a number does not swallow the next one") {
    const LoadResult r = load_objects("s 0 0 0\ns 1 1 1 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:3:1: warning: expected a number for the radius of 's', found 's'"});
    REQUIRE(r.scene->geometry.all<Sphere>().size() == 1);
    CHECK(r.scene->geometry.all<Sphere>()[0].centre == Vec3(1, 1, 1));
}

TEST_CASE("a truncated file is reported at its end") {
    const LoadResult r = load_p3f_text(good_camera + good_material + "s 0 0");
    CHECK(messages(r) ==
          Messages{"a.p3f:11:6: warning: expected a number for the centre of 's', found the end "
                   "of the file"});
    CHECK(r.scene);
    CHECK(messages(load_p3f_text(good_camera + "env"))[0] ==
          "a.p3f:10:4: warning: expected a word for the directory of 'env', found the end of the "
          "file");
}

TEST_CASE("numbers that are not finite are reported and skip the statement") {
    const LoadResult r =
        load_objects("s 0 nan 0 1\ns 0 -INF 0 1\ns 1e400 0 0 1\ns 0x10 0 0 1\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:2:5: warning: expected a number for the centre of 's', found 'nan', "
                   "which is not "
                   "finite",
                   "a.p3f:3:5: warning: expected a number for the centre of 's', found '-INF', "
                   "which is not "
                   "finite",
                   "a.p3f:4:3: warning: expected a number for the centre of 's', found '1e400', "
                   "which is too "
                   "large",
                   "a.p3f:5:3: warning: expected a number for the centre of 's', found '0x10'"});
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("private extensions of single programs are named") {
    for (const std::string word : {"sm", "ms", "a", "al", "fire"}) {
        const LoadResult r = load_objects(word + " -0.5 -0.5 -0.5 0.5 0.5 0.5 0.5 0 3\ns 0 0 0 1");
        CHECK(messages(r) == Messages{"a.p3f:2:1: warning: '" + word +
                                      "' is a private extension of one program; it is left out"});
        CHECK(r.scene->geometry.primitives.size() == 1);
    }
}

TEST_CASE("more warnings of a kind than anyone reads are counted") {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "s 0 0 0 0\n";
    const LoadResult r = load_objects(text);
    CHECK(r.diagnostics.size() == 20);
    CHECK(report(r.diagnostics).ends_with("a.p3f: warning: 980 more of this kind (degenerate)\n"));
}
