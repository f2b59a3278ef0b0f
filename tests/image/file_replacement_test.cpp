#include "core/image/file_replacement.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <fstream>

#include "core/base/hash64.h"
#include "tests/catch.h"
#include "tests/image/ordinary_user.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
namespace fs = std::filesystem;

namespace {

std::string replace(const std::string& path, std::string_view by) {
    FileReplacement file(path);
    file.write(by);
    return file.put_in_place();
}

}  // namespace

TEST_CASE("A file that is replaced keeps its permissions", "[file]") {
    const TemporaryFolder folder;
    const std::string path = folder / "state";
    REQUIRE(replace(path, "old").empty());
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    CHECK(replace(path, "new").empty());
    CHECK(content_of(path) == "new");
    CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("A file that another one is writing is left to it", "[file]") {
    const TemporaryFolder folder;
    const std::string path = folder / "state";
    FileReplacement first(path);
    first.write("first");
    CHECK(replace(path, "second") == path + ": cannot be written: another program is writing it");
    CHECK(first.put_in_place().empty());
    CHECK(content_of(path) == "first");
}

TEST_CASE("A link where the temporary file would be is not followed", "[file]") {
    const TemporaryFolder folder;
    const std::string path = folder / "state", precious = folder / "precious";
    std::ofstream(precious) << "precious";
    fs::create_symlink(precious, folder / fmt::format(".etalon-{:016x}.tmp", hash64("state")));
    const std::string error = replace(path, "new");
    CHECK_THAT(error, Catch::Matchers::StartsWith(path + ": cannot be written"));
    CHECK(content_of(precious) == "precious");
    CHECK_FALSE(fs::exists(path));
}

TEST_CASE("Another user's file that may be written, but not replaced, is overwritten",
          "[file][needs_ordinary_user]") {
    SKIP_UNLESS(::geteuid() == 0, "only root can give a folder to another user");
    const TemporaryFolder folder;
    const std::string path = folder / "state";
    put(path, std::string(200000, 'x'));
    fs::permissions(path, fs::perms(0666));
    fs::permissions(folder / ".", fs::perms(01777));
    const OrdinaryUser user;
    SKIP_UNLESS(::geteuid() != 0, "root cannot become another user here");
    const std::string state = "new" + std::string(100000, 'y');
    CHECK(replace(path, state) == "");
    CHECK((content_of(path) == state));
    CHECK(folder.names() == std::vector<std::string>{"state"});
}
