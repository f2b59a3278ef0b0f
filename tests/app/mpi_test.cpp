// Images rendered by several processes started by mpirun.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "core/image/io.h"
#include "tests/app/mpirun.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

/// A rendering that takes a second or less: uniform and adaptive, with and without a filter.
const std::vector<std::string> tasks = {
    "glass.p3f --spp 24",
    "soft_shadows.p3f --integrator path --spp 12 --filter gaussian",
    "lights.p3f --integrator ao --target-error 8e-4 --aov variance,albedo,sampleCount",
    "mirrors.p3f --integrator path --target-error 2e-2 --filter mitchell --spp 64",
    "spheres.p3f --spp 20 --sampler random --part 1/2",
};

const std::string size = " --resolution 96x72 -q ";

/// A shell's words that render; the shell of each rank may expand them.
std::string render(const std::string& task) {
    return "'" ETALON_BINARY_DIR "/bin/etalon' render '" ETALON_SOURCE_DIR "/scenes/features/'" +
           task + size;
}

/// The same for a scene in the current folder.
std::string render_of(const std::string& task) {
    return "'" ETALON_BINARY_DIR "/bin/etalon' render " + task + size;
}

/// Runs a shell command in each of some ranks.
ProgramResult in_ranks(const Folder& f, int ranks, const std::string& command) {
    f.write("command", command);
    return f.shell(mpirun(ranks) + "sh command");
}

/// Writes a skybox, box, of six faces that take 12 MB each once they are read.
void write_large_skybox(const Folder& f) {
    constexpr int side = 2000;
    const etalon::RenderedImage grey{
        side,
        side,
        {{0, 0}, {side - 1, side - 1}},
        std::vector<etalon::Color>(std::size_t{side} * side, etalon::Color(0.5F)),
        true,
        {}};
    std::filesystem::create_directory(f.path("box"));
    REQUIRE(etalon::write_image(f.path("box/front.png"), grey) == "");
    for (const std::string face : {"back", "left", "right", "top", "bottom"}) {
        std::filesystem::create_symlink("front.png", f.path("box/" + face + ".png"));
    }
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; ++at) ++found;
    return found;
}

}  // namespace

TEST_CASE("Any number of ranks renders the bits of one process", "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    for (const std::string& task : tasks) {
        REQUIRE(f.shell(render(task) + "-t 2 -o one.exr").status == 0);
        for (const int ranks : {1, 2, 3, 5}) {
            const auto r = f.shell(mpirun(ranks) + render(task) +
                                   fmt::format("-t {} -o many.exr", 1 + ranks % 2));
            CAPTURE(task, ranks, r.err);
            CHECK(r.status == 0);
            CHECK(f.read("many.exr") == f.read("one.exr"));
            f.shell("rm -f many.exr");
        }
    }
}

TEST_CASE("Ranks share the tiles, and rank 0 alone speaks", "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    f.write("ball.p3f", small_scene + "no_such_statement\n");
    const std::string task =
        "'" ETALON_BINARY_DIR "/bin/etalon' render ball.p3f --resolution 160x96 --spp 2048 -t 1 ";
    REQUIRE(f.shell(task + "-q -o one.exr --stats one.json").status == 0);
    const auto r = f.shell(mpirun(3) + task + "-o many.exr --stats many.json");
    CHECK(r.status == 0);
    CHECK(count(r.err, "no_such_statement") == 1);
    CHECK(count(r.err, "-> many.exr") == 1);
    CHECK(f.read("many.exr") == f.read("one.exr"));
    const json one = json::parse(f.read("one.json")), many = json::parse(f.read("many.json"));
    CHECK(many["rays"] == one["rays"]);
    CHECK_FALSE(one.contains("ranks"));
    const json& ranks = many["ranks"];
    CHECK(ranks["count"] == 3);
    CHECK(ranks["tiles"].size() == 3);
    CHECK(ranks["bytes_sent"] > 0);
    const std::vector<int> tiles = ranks["tiles"];
    for (const int of_rank : tiles) CHECK(of_rank > 0);
    // Passes of 1, 2, 4, ... 2048 samples.
    CHECK(std::accumulate(tiles.begin(), tiles.end(), 0) == 12 * 10 * 6);
}

TEST_CASE("Ranks write an image to the standard output of mpirun", "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    f.write("ball.p3f", small_scene);
    REQUIRE(f.shell(render_of("ball.p3f --spp 4") + "-o a.png").status == 0);
    const auto r = f.shell(mpirun(2) + render_of("ball.p3f --spp 4") + "-o - --output-format png");
    CHECK(r.status == 0);
    CHECK(r.out == f.read("a.png"));
}

TEST_CASE("A rank that has another scene, or none, ends the rendering by name",
          "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    f.write("scene0.p3f", small_scene);
    const std::string command = "exec '" ETALON_BINARY_DIR
                                "/bin/etalon' render scene$OMPI_COMM_WORLD_RANK.p3f --spp 60000 "
                                "-q -o a.exr --checkpoint no/such/folder/c";
    const auto missing = in_ranks(f, 2, command);
    CHECK(missing.status == 3);
    CHECK_THAT(missing.err, ContainsSubstring("error: rank 1 has failed: scene1.p3f"));
    f.write("scene1.p3f", small_scene + "s 0 2 0 0.5\n");
    const auto other = in_ranks(f, 2, command);
    CHECK(other.status == 3);
    CHECK_THAT(other.err, ContainsSubstring("error: rank 1 renders another image: scene is"));
    CHECK_THAT(other.err, !ContainsSubstring("--resume goes on"));
    CHECK_FALSE(f.has("a.exr"));
}

TEST_CASE("A scene that rank 0 sends need not be where the others are", "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    f.shell("mkdir -p here/scenes nowhere && cp -r '" ETALON_SOURCE_DIR
            "/scenes/features' "
            "'" ETALON_SOURCE_DIR "/scenes/pbrt' '" ETALON_SOURCE_DIR
            "/scenes/skybox' here/scenes && ln -s scenes/skybox here/link && mkdir here/empty");
    f.write("here/detour.pbrt",
            "LookAt 0 0 -5 0 0 0 0 1 0 Camera \"perspective\" WorldBegin LightSource \"point\" "
            "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" "
            "\"empty/../scenes/skybox/top.png\" Material \"matte\" \"texture Kd\" \"t\" "
            "Shape \"sphere\" WorldEnd\n");
    const std::string options = " --spp 2 --resolution 60x40 -t 1 -q -o ",
                      one = "cd here; '" ETALON_BINARY_DIR "/bin/etalon' render ";
    for (const std::string scene :
         {"scenes/features/skybox.p3f", "scenes/pbrt/textures.pbrt", "scenes/pbrt/shapes.pbrt",
          "- <scenes/features/glass.p3f", "scenes/features/../pbrt/textures.pbrt",
          "link/../features/glass.p3f", "detour.pbrt"}) {
        CAPTURE(scene);
        REQUIRE(f.shell(one + scene + options + "one.exr").status == 0);
        const std::string input = scene[0] == '-' ? f.read("here/scenes/features/glass.p3f") : "";
        const std::string many =
            "test $OMPI_COMM_WORLD_RANK = 0 && cd here || cd nowhere; "
            "export TMPDIR=$PWD; exec '" ETALON_BINARY_DIR "/bin/etalon' render " +
            scene.substr(0, scene.find(' ')) + options + "many.exr --stats many.json --mpi-scene ";
        f.write("command", many + "broadcast");
        const auto r = f.shell("exec " + mpirun(4) + "sh command", input);
        CAPTURE(r.err);
        CHECK(r.status == 0);
        CHECK(f.read("here/many.exr") == f.read("here/one.exr"));
        CHECK(f.shell("ls -A nowhere").out.empty());
        if (input.empty()) CHECK(in_ranks(f, 2, many + "each").status == 3);
    }
}

TEST_CASE("A rank whose memory an image does not fit into ends the rendering",
          "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    SKIP_UNLESS(!is_sanitized, "memory cannot be limited");
    write_large_skybox(f);
    f.write("sky.p3f", small_scene + "env box\n");
    // Not as two programs of one mpirun: that of Open MPI 5.0 ends by a segmentation fault.
    const auto r = in_ranks(f, 2,
                            "test $OMPI_COMM_WORLD_RANK = 0 || limit='--max-memory 30M'\nexec " +
                                render_of("sky.p3f --spp 20") + " -t 1 -o a.exr $limit\n");
    CAPTURE(r.err);
    CHECK(r.status == 3);
    CHECK_THAT(r.err, ContainsSubstring("rank 1 has failed: box/"));
    CHECK_THAT(r.err, ContainsSubstring("not enough memory"));
    CHECK_FALSE(f.has("a.exr"));
}

TEST_CASE("A face of a skybox that another rank cannot read is reported once, with the image",
          "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    f.shell("cp -r '" ETALON_SOURCE_DIR "/scenes/skybox' . && truncate -s -90 skybox/*.png");
    f.write("sky.p3f", small_scene + "env skybox\n");
    const std::string task = render_of("\"$PWD/sky.p3f\" --spp 16 --strict -t 1 ");
    const auto one = f.shell(task + " -o one.exr");
    REQUIRE(one.status == 3);
    REQUIRE(f.has("one.exr"));
    const auto many = f.shell(mpirun(3) + task + " -o many.exr --mpi-scene broadcast");
    CAPTURE(one.err, many.err);
    CHECK(many.status == 3);
    CHECK(f.read("many.exr") == f.read("one.exr"));
    CHECK_THAT(many.err, ContainsSubstring(one.err));
    CHECK(count(many.err, "error: ") == count(one.err, "error: "));
}

TEST_CASE("Ranks render on the threads for whose stacks there is memory", "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    SKIP_UNLESS(!is_sanitized, "memory cannot be limited");
    const std::string task = render("glass.p3f --spp 2");
    REQUIRE(f.shell(task + "-o one.exr").status == 0);
    const auto r = f.shell(mpirun(2) + task + "-t 60 --max-memory 300M -o many.exr");
    CAPTURE(r.err);
    CHECK(r.status == 0);
    CHECK(f.read("many.exr") == f.read("one.exr"));
}

TEST_CASE("The copy of a scene stays in its folder, and --root moves with it",
          "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    const std::string included = "LightSource \"infinite\"\n";
    f.write("inc.pbrt", included);
    f.shell("mkdir in; cp inc.pbrt in");
    const auto render_including = [&](const std::string& path, const std::string& options) {
        f.write("in/s.pbrt", "WorldBegin Include \"" + path + "\" Shape \"sphere\" WorldEnd\n");
        return f.shell("cd in && " + mpirun(3) +
                       "'" ETALON_BINARY_DIR
                       "/bin/etalon' render s.pbrt -q --resolution 8x8 -o a.exr "
                       "--mpi-scene broadcast " +
                       options);
    };
    std::string up;
    for (int i = 0; i < 20; ++i) up += "../";
    render_including(up + f.path("inc.pbrt").substr(1), "");
    CHECK(f.read("inc.pbrt") == included);
    CHECK(render_including("inc.pbrt", "--root $PWD").status == 0);
    CHECK(render_including("../inc.pbrt", "").status == 0);
    CHECK(render_including("../inc.pbrt", "--root $PWD").status == 3);
    CHECK(f.read("inc.pbrt") == included);
}

TEST_CASE("When a rank is killed, the rendering can be resumed", "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    const std::string task = render("glass.p3f --spp 500") + "-t 1 ";
    REQUIRE(f.shell(task + "-o whole.exr").status == 0);
    f.write("rank", "echo $$ >pid$OMPI_COMM_WORLD_RANK; exec " + task +
                        "-o image.exr --checkpoint c --checkpoint-every 0.1 --resume");
    for (const int victim : {2, 0}) {
        f.shell("rm -f c pid*");
        // Waits for the first checkpoint, unless the program has ended.
        const auto r = f.shell(fmt::format(
            "{}sh rank & run=$!; while kill -0 $run && ! test -s c; do sleep 0.02; done; "
            "kill -KILL $(cat pid{}); wait $run",
            mpirun(3), victim));
        CAPTURE(victim, r.err);
        CHECK(r.status == 128 + 9);
        CHECK_THAT(r.err, ContainsSubstring("signal 9"));
        if (victim > 0) CHECK_THAT(r.err, ContainsSubstring("--resume goes on from c"));
        CHECK(f.has("c"));
        const auto resumed = f.shell(mpirun(2) + "sh rank");
        CAPTURE(resumed.err);
        CHECK(resumed.status == 0);
        CHECK_THAT(resumed.err, !ContainsSubstring("begins anew"));
        CHECK(f.read("image.exr") == f.read("whole.exr"));
    }
}

TEST_CASE("Processes of another MPI's launcher report once that they do not meet",
          "[app][needs_mpirun]") {
    const Folder f;
    SKIP_UNLESS(has_mpirun(f), "mpirun is not installed");
    f.write("ball.p3f", small_scene);
    const std::string second = std::string(with_mpi) + "PMI_SIZE=2 PMI_RANK=";
    const std::string render = " " ETALON_BINARY_DIR "/bin/etalon render ball.p3f -q -o a.exr";
    const auto first = f.shell(second + "0" + render);
    CHECK(first.status == 3);
    CHECK_THAT(first.err,
               ContainsSubstring("is process 1 of 2 to its launcher, 1 of 1 to its MPI"));
    const auto last = f.shell(second + "1" + render);
    CHECK(last.status == 3);
    CHECK(last.err.empty());
    CHECK_FALSE(f.has("a.exr"));
}

TEST_CASE("Ranks without the MPI module report that once", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string program = "ETALON_MODULE_PATH=. " ETALON_BINARY_DIR "/bin/etalon ";
    const std::string second = "OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=";
    const auto first = f.shell(second + "0 " + program + "render ball.p3f -o a.exr");
    CHECK(first.status == 3);
    CHECK_THAT(first.err, ContainsSubstring("built or installed without MPI"));
    CHECK(f.shell(second + "1 " + program + "render ball.p3f -o a.exr").err.empty());
    CHECK_FALSE(f.has("a.exr"));
    CHECK(f.shell("OMPI_COMM_WORLD_SIZE=1 OMPI_COMM_WORLD_RANK=0 " + program +
                  "render ball.p3f -o a.exr")
              .status == 0);
    const auto usage = f.shell(second + "1 " + program + "render --no-such-option");
    CHECK(usage.status == 2);
    CHECK(usage.err.empty());
}
