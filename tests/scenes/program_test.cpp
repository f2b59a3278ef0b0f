#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/scenes/generated_scenes.h"

using namespace etalon::test;

namespace {

const std::string program = "exec " ETALON_BINARY_DIR "/bin/etalon-scenes ";

ProgramResult generate(const Folder& folder, const std::string& arguments) {
    return folder.shell(program + arguments);
}

/// FNV-1a, 64 bits.
std::uint64_t hash(const std::string& text) {
    std::uint64_t h = 0xCBF29CE484222325U;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return h;
}

}  // namespace

TEST_CASE("etalon-scenes writes a file or standard output, with the same text", "[scenes]") {
    const Folder folder;
    const auto result = generate(folder, "tetra --size 2 -o t.p3f");
    CHECK(result.status == 0);
    CHECK(result.out + result.err == "");
    CHECK(folder.read("t.p3f") == family_text("tetra", 2));
    CHECK(generate(folder, "tetra --size 2 -o -").out == folder.read("t.p3f"));
}

TEST_CASE("etalon-scenes leaves other files alone, and nothing behind at a signal", "[scenes]") {
    const Folder folder;
    folder.write("t.p3f.part", "keep");
    CHECK(generate(folder, "tetra --size 1 -o t.p3f").status == 0);
    CHECK(folder.read("t.p3f.part") == "keep");
    const std::string large = "etalon-scenes soup --size 100000000 -o large.p3f";
    for (const std::string signal : {"INT", "TERM"}) {
        const auto r = interrupted(folder, large, has_worked(20), signal);
        CHECK(r.status == (signal == "INT" ? 130 : 143));
        CHECK(folder.shell("ls -A | grep -c -e large -e tmp").out == "0\n");
    }
}

TEST_CASE("etalon-scenes writes through symbolic links, also to nothing yet", "[scenes]") {
    const Folder folder;
    folder.shell("mkdir there; ln -s there/link link; ln -s file there/link");
    for (const std::string size : {"1", "2"}) {
        CHECK(generate(folder, "tetra -o link --size " + size).status == 0);
        CHECK(folder.shell("test -L link && test -L there/link && test -f there/file").status == 0);
        CHECK(folder.read("there/file") == family_text("tetra", std::stoi(size)));
    }
    CHECK(folder.shell("ls -A . there").out ==
          folder.shell("printf '.:\nlink\nthere\n\nthere:\nfile\nlink\n'").out);
}

TEST_CASE("etalon-scenes exits with 2 on wrong usage and prints what is valid", "[scenes]") {
    const Folder folder;
    const auto unknown = generate(folder, "teapot");
    CHECK(unknown.status == 2);
    CHECK_THAT(unknown.err, ContainsSubstring("teapot") && ContainsSubstring("sphereflake") &&
                                ContainsSubstring("mountain"));
    const auto size = generate(folder, "tetra --size 99");
    CHECK(size.status == 2);
    CHECK_THAT(size.err, ContainsSubstring("0 to 14"));
    for (const char* wrong :
         {"", "tetra --size -1", "tetra --size many", "rings --size 0", "tetra --frobnicate",
          "tetra rings", "tetra -o t.pbrt", "tetra -o t.nff", "forest --size 1 -o f.p3f"}) {
        INFO(wrong);
        CHECK(generate(folder, wrong).status == 2);
    }
    CHECK(generate(folder, "--help").status == 0);
    CHECK_THAT(generate(folder, "sphereflak").err,
               ContainsSubstring("did you mean 'sphereflake'?"));
    const std::string version = generate(folder, "--version").out;
    const std::string same = folder.shell(ETALON_BINARY_DIR "/bin/etalon --version").out;
    CHECK(same.find(version.substr(0, version.size() - 1).erase(6, 7)) == 0);  // without "-scenes"
}

TEST_CASE("etalon-scenes ends with 4 where it cannot write, and leaves nothing behind",
          "[scenes]") {
    const Folder folder;
    CHECK(generate(folder, "tetra -o no/such/folder.p3f").status == 4);
    CHECK(generate(folder, "tetra >/dev/full").status == 4);
    CHECK(generate(folder, "tetra -o /dev/full").status == 4);
    folder.shell("mkdir taken");
    CHECK(generate(folder, "tetra -o taken").status == 4);
    const std::string full_disk = "trap '' XFSZ; ulimit -f 8; ";  // blocks of 512 bytes
    CHECK(folder.shell(full_disk + program + "tetra -o large.p3f").status == 4);
    CHECK(folder.shell("ls -A").out == "taken\n");
}

TEST_CASE("A family's text is the same on every machine", "[scenes]") {
    // An intended change of a family needs a new line here.
    const auto [family, size, expected] = GENERATE(table<std::string, std::int64_t, std::uint64_t>({
        {"sphereflake", 3, 0xEC1EAF4134248EC4},
        {"tetra", 4, 0x4C3B52ECABAE6B19},
        {"mountain", 5, 0x7FB33791C765A237},
        {"rings", 3, 0x10C5B43218EA8FA9},
        {"gears", 2, 0x67A27BA6768C1E17},
        {"tree", 7, 0x734FDD3045A67A2C},
        {"soup", 1000, 0xB549503B9F6B12F7},
        {"spheres", 1000, 0xEEAD410A9EBBB6C3},
        {"forest", 100, 0xE9C7214A86D7CDAD},
        {"plaza", 100, 0x737BB743C159B0BA},
    }));
    INFO(family);
    CHECK(hash(family_text(family, size)) == expected);
}
