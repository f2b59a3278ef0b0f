// Real scenes, if this machine has them.
#include <filesystem>

#include "core/formats/file_text.h"
#include "core/formats/pbrt/write_frames.h"
#include "tests/formats/pbrt/pbrt_text.h"
#include "tests/formats/pbrt/same_frame.h"
#include "tests/formats/shared_scenes.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

std::vector<std::string> pbrt_files() {
    std::vector<std::string> list;
    std::error_code missing;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(shared_scenes_folder() / "pbrt", missing)) {
        if (entry.path().extension() == ".pbrt") list.push_back(entry.path().string());
    }
    return list;
}

/// Expected messages about the few files with defects, by file name.
const std::vector<std::pair<std::string, std::string>> known_flaws = {
    {"goniometric.pbrt", "unused"}, {"spot.pbrt", "unused"}, {"stratified.pbrt", "unused"}};

bool is_known(const std::string& path, const Diagnostic& d) {
    return std::ranges::any_of(known_flaws, [&](const auto& flaw) {
        return std::filesystem::path(path).filename() == flaw.first && d.kind == flaw.second;
    });
}

}  // namespace

TEST_CASE("public scenes are read without a complaint that they do not deserve",
          "[needs_shared_scenes]") {
    const std::vector<std::string> paths = pbrt_files();
    SKIP_UNLESS(!paths.empty(), "no scenes in " << shared_scenes_folder() / "pbrt");
    for (const std::string& path : paths) {
        if (std::filesystem::path(path).parent_path().filename() == "geometry") continue;
        CAPTURE(path);
        const FileText text = read_file(path);
        REQUIRE(text.error.empty());
        const ParsedFile file = parse(text.text(), path);
        CHECK(file.frames.size() == 1);
        CHECK_FALSE(file.is_fatal);
        for (const Diagnostic& d : file.diagnostics) {
            CAPTURE(to_string(d));
            CHECK(is_known(path, d));
        }
        CHECK_FALSE(file.frames.at(0).shapes.empty());
    }
}

TEST_CASE("public scenes are the same when written and read again", "[needs_shared_scenes]") {
    const std::vector<std::string> paths = pbrt_files();
    SKIP_UNLESS(!paths.empty(), "no scenes in " << shared_scenes_folder() / "pbrt");
    for (const std::string& path : paths) {
        CAPTURE(path);
        const FileText text = read_file(path);
        const ParsedFile file = parse(text.text(), path);
        std::string anew;
        const std::filesystem::path directory = std::filesystem::path(path).parent_path();
        write_frames(file.frames, directory, [&](std::string_view piece) { anew += piece; });
        const ParsedFile again = parse(anew, path);
        if (file.frames.empty()) continue;
        CHECK(messages(again) == Messages{});
        REQUIRE(again.frames.size() == 1);
        CHECK(difference(file.frames[0], again.frames[0]) == "");
    }
}
