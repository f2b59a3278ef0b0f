#include <filesystem>

#include "tests/formats/pbrt/pbrt_text.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

namespace fs = std::filesystem;

/// The files of one test.
class Folder {
  public:
    std::string file(const std::string& name, const std::string& text) const {
        const fs::path path = path_of(name);
        fs::create_directories(path.parent_path());
        test::put(path.string(), text);
        return path.string();
    }

    /// Reads text as the file top.pbrt of the folder.
    ParsedFile parse(const std::string& text) const {
        return etalon::pbrt::parse(text, path_of("top.pbrt"));
    }

    /// Returns the messages without the folder's name.
    Messages said(const ParsedFile& file) const {
        Messages list = messages(file);
        for (std::string& m : list) {
            const std::string folder = path_of("");
            for (std::size_t at = m.find(folder); at != std::string::npos; at = m.find(folder)) {
                m.erase(at, folder.size());
            }
        }
        return list;
    }

  private:
    std::string path_of(const std::string& name) const { return folder_ / name; }

    test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("an included file is read in its place") {
    const Folder folder;
    folder.file("part.pbrt", "Translate 1 0 0\nShape \"sphere\"");
    const ParsedFile file = folder.parse(
        "WorldBegin Include \"part.pbrt\" Shape \"disk\" Include \"part.pbrt\" WorldEnd");
    CHECK(folder.said(file) == Messages{});
    const Frame& frame = file.frames.at(0);
    REQUIRE(frame.shapes.size() == 3);
    CHECK(image(start(frame, frame.shapes[1]), {0, 0, 0}) == Vec3(1, 0, 0));
    CHECK(image(start(frame, frame.shapes[2]), {0, 0, 0}) == Vec3(2, 0, 0));
    CHECK(fs::path(file.files.at(frame.shapes[0].plugin.where.file)).filename() == "part.pbrt");
    CHECK(frame.shapes[0].plugin.where.line == 2);
}

TEST_CASE("all paths are from the directory of the file that was asked for") {
    const Folder folder;
    folder.file("a/one.pbrt",
                "Include \"b/two.pbrt\" Shape \"plymesh\" \"string filename\" \"m.ply\"");
    folder.file("b/two.pbrt", "Shape \"sphere\"");
    const ParsedFile file = folder.parse("WorldBegin Include \"a/one.pbrt\" WorldEnd");
    CHECK(folder.said(file) == Messages{});
    REQUIRE(file.frames.at(0).shapes.size() == 2);
    const fs::path mesh = file.frames[0].shapes[1].plugin.parameters.string("filename");
    CHECK(mesh.parent_path() == fs::path(file.files[0]).parent_path());
}

TEST_CASE("the end of an included file is no more than a blank") {
    const Folder folder;
    folder.file("a.pbrt", "Shape \"sphere\" \"float radius\"");
    const ParsedFile file = folder.parse("WorldBegin Include \"a.pbrt\" 3 WorldEnd");
    CHECK(folder.said(file) == Messages{});
    CHECK(file.frames.at(0).shapes.at(0).plugin.parameters.number("radius") == 3);
}

TEST_CASE("diagnostics name the included file and its line") {
    const Folder folder;
    folder.file("a.pbrt", "\n\n  NamedMaterial \"m\"");
    const ParsedFile file =
        folder.parse("WorldBegin\nInclude \"a.pbrt\"\nNamedMaterial \"n\"\nWorldEnd");
    CHECK(folder.said(file) ==
          Messages{"a.pbrt:3:3: error: no material 'm' is defined; the current one stays",
                   "top.pbrt:3:1: error: no material 'n' is defined; the current one stays"});
}

TEST_CASE("a file that is missing is an error, and reading goes on") {
    const Folder folder;
    const ParsedFile file =
        folder.parse("WorldBegin Include \"none.pbrt\" Shape \"sphere\" WorldEnd");
    CHECK(folder.said(file) ==
          Messages{"top.pbrt:1:12: error: 'none.pbrt' cannot be opened: No such "
                   "file or directory; it is left out"});
    CHECK_FALSE(file.is_fatal);
    CHECK(file.frames.at(0).shapes.size() == 1);
}

TEST_CASE("a file that is missing is named in full, however long its path is") {
    const Folder folder;
    const std::string name = std::string(100, 'x') + "/none.pbrt";
    const auto said = folder.said(folder.parse("WorldBegin Include \"" + name + "\" WorldEnd"));
    REQUIRE(said.size() == 1);
    CHECK(said[0].find("'" + name + "'") != std::string::npos);
}

TEST_CASE("a file that includes itself is told so") {
    const Folder folder;
    folder.file("a.pbrt", "Include \"b.pbrt\" Shape \"sphere\"");
    folder.file("b.pbrt", "Include \"x/../a.pbrt\" Shape \"sphere\"");
    const ParsedFile file = folder.parse("WorldBegin Include \"a.pbrt\" WorldEnd");
    CHECK(folder.said(file) == Messages{"b.pbrt:1:1: error: 'a.pbrt' is not included: it would "
                                        "include itself without end"});
    CHECK(file.frames.at(0).shapes.size() == 2);
    const ParsedFile top = folder.parse("WorldBegin Include \"top.pbrt\" WorldEnd");
    REQUIRE(top.diagnostics.size() == 1);
    CHECK(top.diagnostics[0].kind == "include");
}

TEST_CASE("files that include each other ever deeper come to an end") {
    const Folder folder;
    for (int i = 0; i < 120; ++i) {
        folder.file(std::to_string(i),
                    "Include \"" + std::to_string(i + 1) + "\" Shape \"sphere\"");
    }
    const ParsedFile file = folder.parse("WorldBegin Include \"0\" WorldEnd");
    REQUIRE(file.diagnostics.size() == 1);
    CHECK(file.diagnostics[0].message.find("100 deep") != std::string::npos);
    CHECK(file.frames.at(0).shapes.size() == 100);
}

TEST_CASE("files that include each other ever more often come to an end") {
    const Folder folder;
    for (int i = 0; i < 40; ++i) {
        const std::string next = "Include \"" + std::to_string(i + 1) + "\" ";
        folder.file(std::to_string(i), next + next);
    }
    folder.file("40", "");
    const ParsedFile file = folder.parse("WorldBegin Include \"0\" WorldEnd");
    REQUIRE_FALSE(file.diagnostics.empty());
    CHECK(file.diagnostics[0].message.find("100000 files were included") != std::string::npos);
}

TEST_CASE("a spectrum is read from its file once, and what is wrong with it said") {
    const Folder folder;
    folder.file("s.spd", "400 1\n700 x\n");
    const ParsedFile file = folder.parse(
        "WorldBegin LightSource \"point\" \"spectrum I\" \"s.spd\" LightSource \"point\" "
        "\"spectrum I\" "
        "\"s.spd\" WorldEnd");
    CHECK_FALSE(file.diagnostics.empty());
    for (const Diagnostic& d : file.diagnostics) CHECK(fs::path(d.file).filename() == "s.spd");
    CHECK(file.diagnostics.size() <= 2);
    const Frame& frame = file.frames.at(0);
    CHECK(frame.lights.at(0).plugin.parameters.color("I") ==
          frame.lights.at(1).plugin.parameters.color("I"));
    CHECK(frame.lights.at(0).plugin.parameters.color("I").y > 0);
}

TEST_CASE("a file may be included anywhere") {
    const Folder folder;
    folder.file("options.pbrt", "Sampler \"sobol\"");
    const ParsedFile file = folder.parse("Include \"options.pbrt\" WorldBegin WorldEnd");
    CHECK(folder.said(file) == Messages{});
    CHECK(file.frames.at(0).sampler.type->name == "sobol");
}
