#include "core/formats/mapped_file.h"

#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;

TEST_CASE("a mapped file has the bytes of the file") {
    const test::TemporaryFolder folder;
    for (const std::string& content : {std::string("\0a\n", 3), std::string(100000, 'x')}) {
        test::put(folder / "file", content);
        MappedFile file(folder / "file");
        CHECK(file.error().empty());
        CHECK(file.text() == content);
        const MappedFile moved = std::move(file);
        CHECK(moved.text() == content);
    }
}

TEST_CASE("what is not a file with bytes is no mapped file, and says why") {
    const test::TemporaryFolder folder;
    test::put(folder / "empty", "");
    CHECK(MappedFile(folder / "empty").error().empty());
    CHECK(MappedFile(folder / "empty").text().empty());
    CHECK_THAT(MappedFile(folder / "none").error(), ContainsSubstring("cannot be opened"));
    CHECK(MappedFile(folder / "").error() == "is a directory");
    CHECK(MappedFile("/proc/self/status").text().starts_with("Name:"));
}
