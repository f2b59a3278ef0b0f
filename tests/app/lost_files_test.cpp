// Files that no combination of options may lose, and outputs that cannot be written.
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

TEST_CASE("An output that is an input is refused, and the input stays", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.write("rays", "0 0 5 0 0 -1 0 inf\n");
    REQUIRE(f.etalon("render ball.p3f -q -o a.exr -o a.png").status == 0);
    const std::string image = f.read("a.exr"), png = f.read("a.png"), rays = f.read("rays");
    f.shell("ln -s ball.p3f link; cp ball.p3f ball.exr");
    for (const char* command :
         {"render ball.p3f -o b.exr --stats ball.p3f", "render ball.p3f -o b.exr --stats ./link",
          "render ball.p3f -o b.exr --checkpoint ball.p3f", "render ball.exr",
          "render ball.p3f -o a.exr --reference a.exr", "trace ball.p3f --rays rays -o ball.p3f",
          "trace ball.p3f --rays rays -o rays", "crosscheck ball.p3f --rays 9 --json ball.p3f",
          "compare a.exr a.png --json a.exr", "compare a.exr a.png --heatmap a.png",
          "convert ball.p3f -o ../$(basename $PWD)/ball.p3f"}) {
        const auto r = f.etalon(command);
        INFO(command);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("is an input, which would be lost"));
    }
    CHECK(f.read("ball.p3f") == small_scene);
    CHECK(f.read("ball.exr") == small_scene);
    CHECK(f.read("a.exr") == image);
    CHECK(f.read("a.png") == png);
    CHECK(f.read("rays") == rays);
}

TEST_CASE("A report does not replace its scenes nor its table", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.shell("mkdir same");
    const std::string table = "cpu_s\trelmse\tscene\n1\t0.1\t../ball.p3f\n";
    for (const std::string input : {"index.html", "data.json", "speed-all.csv"}) {
        for (const std::string what : {"", "--foreign "}) {
            CAPTURE(input, what);
            const std::string content = what.empty() ? small_scene : table;
            f.write("same/" + input, content);
            const auto r = f.shell("'" ETALON_BINARY_DIR "/bin/etalon-bench' report --quick " +
                                   what + "same/" + input + " -o ./same");
            CHECK(r.status == 2);
            CHECK_THAT(r.err, ContainsSubstring(input + ": is an input, which would be lost"));
            CHECK(f.read("same/" + input) == content);
            f.shell("rm same/*");
        }
    }
}

TEST_CASE("A converted scene does not replace what it includes", "[app]") {
    const Folder f;
    f.write("ball.pbrt", "Shape \"sphere\"\n");
    f.write("scene.pbrt", "WorldBegin Include \"ball.pbrt\" WorldEnd\n");
    const auto r = f.etalon("convert scene.pbrt -o ./ball.pbrt");
    CHECK(r.status == 2);
    CHECK_THAT(r.err, ContainsSubstring("is an input, which would be lost"));
    CHECK(f.read("ball.pbrt") == "Shape \"sphere\"\n");
    CHECK(f.etalon("convert scene.pbrt -o again.pbrt").status == 0);
}

TEST_CASE("A path through a linked folder leads where it does for the system", "[app]") {
    const Folder f;
    f.shell("mkdir -p real/deep; ln -s real/deep link");
    f.write("real/ball.pbrt", "Shape \"sphere\"\n");
    f.write("scene.pbrt", "WorldBegin Include \"link/../ball.pbrt\" WorldEnd\n");
    const auto r = f.etalon("info scene.pbrt");
    CHECK(r.err == "");
    CHECK(r.status == 0);
}

TEST_CASE("No output replaces a file that the scene itself names", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.write("rays", "0 0 5 0 0 -1 0 inf\n");
    f.write("ball.inc", "Shape \"sphere\"\n");
    f.write("triangle.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    f.write(
        "scene.pbrt",
        "WorldBegin Include \"ball.inc\" Shape \"plymesh\" \"string filename\" \"triangle.ply\"\n"
        "LightSource \"infinite\" \"string mapname\" \"scene.exr\"\n"
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"texture.png\" WorldEnd\n");
    f.write("box.p3f", small_scene + "env box\n");
    REQUIRE(f.etalon("render ball.p3f -q -o scene.exr -o texture.png").status == 0);
    f.shell(
        "mkdir box; for face in right left top bottom front back; do "
        "cp texture.png box/$face.png; done; ln -s texture.png link.png");
    const Folder kept;
    f.shell("cp -r . '" + kept.path("") + "'");
    for (const char* command :
         {"etalon render scene.pbrt --spp 1", "etalon render scene.pbrt -o texture.png",
          "etalon render scene.pbrt -o link.png",
          "etalon render scene.pbrt -o a.exr --stats ball.inc",
          "etalon render scene.pbrt -o a.exr --checkpoint triangle.ply",
          "etalon render box.p3f -o box/left.png",
          "etalon trace scene.pbrt --rays rays -o ball.inc",
          "etalon crosscheck scene.pbrt --rays 9 --json triangle.ply",
          "etalon-bench speed --scene scene.pbrt --only-build --json ball.inc",
          "etalon-bench frames scene.pbrt --repeat 1 --json texture.png",
          "etalon-bench convergence scene.pbrt --spp 4 --csv scene.exr",
          "etalon-bench convergence ball.p3f --spp 4 --reference scene.exr --csv scene.exr"}) {
        const auto r = f.shell(ETALON_BINARY_DIR "/bin/" + std::string(command));
        INFO(command);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("is an input, which would be lost"));
    }
    CHECK(f.shell("diff -r . '" + kept.path("") + "'").out == "");
}

TEST_CASE("An image that a scene names and nobody has yet may be made", "[app]") {
    const Folder f;
    f.write("scene.pbrt",
            "WorldBegin LightSource \"infinite\" \"string mapname\" \"scene.exr\" "
            "Shape \"sphere\" WorldEnd\n");
    CHECK(f.etalon("render scene.pbrt --spp 1 -q").status == 0);
    CHECK(f.has("scene.exr"));
}

TEST_CASE("A file for two outputs is refused", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const char* outputs : {"-o a.exr --stats a.exr", "-o a.exr -o ./a.exr",
                                "-o a.exr --checkpoint a.exr", "--stats s --checkpoint ./s"}) {
        const auto r = f.etalon(std::string("render ball.p3f ") + outputs);
        INFO(outputs);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("is given for two outputs"));
        CHECK_FALSE(f.has("a.exr"));
    }
    CHECK(f.etalon("render ball.p3f -q -o a.exr --stats /dev/null --checkpoint c").status == 0);
}

TEST_CASE("What cannot be written is said before the rendering", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.shell("ln -s nowhere/a.exr link.exr; mkdir there; ln -s there/a.exr good.exr");
    const std::string long_name = std::string(300, 'a') + ".exr";
    for (const std::string& name : {std::string("link.exr"), long_name}) {
        const auto r = f.etalon("render ball.p3f --time-limit 60 -o " + name);
        CHECK(r.status == 4);
        CHECK_THAT(r.err, ContainsSubstring("cannot be written"));
    }
    CHECK(f.etalon("render ball.p3f -q -o good.exr").status == 0);
    CHECK(f.has("there/a.exr"));
}

TEST_CASE("Two outputs whose places are unknown are two files", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.shell("ln -s loop loop");
    const std::string name(300, 'x');
    const std::pair<std::string, std::string> cases[] = {
        {"loop/", "Too many levels of symbolic links"}, {name, "File name too long"}};
    for (const auto& [begin, reason] : cases) {
        const auto r =
            f.etalon("render ball.p3f -q -o " + begin + "a.exr --stats " + begin + "b.json");
        CHECK(r.status == 4);
        CHECK_THAT(r.err, ContainsSubstring("a.exr: cannot be written: "));
        CHECK_THAT(r.err, ContainsSubstring(reason));
    }
    CHECK(f.etalon("render ball.p3f -q -o loop/a.exr --stats loop/a.exr").status == 2);
}
