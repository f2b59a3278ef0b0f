#include "core/image/atomic_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <thread>

#include "core/base/uninterrupted.h"
#include "tests/catch.h"
#include "tests/image/ordinary_user.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
namespace fs = std::filesystem;

namespace {

int mode_of(const std::string& path) {
    struct stat s = {};
    return ::stat(path.c_str(), &s) == 0 ? static_cast<int>(s.st_mode & 0777) : -1;
}

/// Limits the size of all files of this process to `bytes` during its lifetime, like a full disk.
class SmallDisk {
  public:
    explicit SmallDisk(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~SmallDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

  private:
    rlimit before_ = {};
    void (*handler_)(int);
};

}  // namespace

TEST_CASE("a file written atomically holds exactly the content, and nothing is beside it") {
    const TemporaryFolder folder;
    const std::string content("a\0b\n", 4);
    CHECK(write_file_atomically(folder / "f", content).empty());
    CHECK(content_of(folder / "f") == content);
    CHECK(write_file_atomically(folder / "f", "").empty());
    CHECK(content_of(folder / "f").empty());
    CHECK(folder.names() == std::vector<std::string>{"f"});
}

TEST_CASE("a new file has the umask's permissions, a replaced one keeps its own") {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    CHECK(write_file_atomically(folder / "f", "1").empty());
    ::umask(before);
    CHECK(mode_of(folder / "f") == 0640);
    ::chmod((folder / "f").c_str(), 0604);
    CHECK(write_file_atomically(folder / "f", "2").empty());
    CHECK(mode_of(folder / "f") == 0604);
    CHECK(content_of(folder / "f") == "2");
}

TEST_CASE("writing through symbolic links to nothing makes the file they name") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "there");
    fs::create_symlink("there/link", folder / "link");
    fs::create_symlink("file", folder / "there/link");
    CHECK(write_file_atomically(folder / "link", "new").empty());
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(fs::is_symlink(folder / "there/link"));
    CHECK(fs::is_regular_file(folder / "there/file"));
}

TEST_CASE("writing through a symbolic link replaces the file it names") {
    const TemporaryFolder folder;
    put(folder / "file", "old");
    fs::create_symlink("file", folder / "link");
    CHECK(write_file_atomically(folder / "link", "new").empty());
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(content_of(folder / "file") == "new");
}

TEST_CASE("the longest file name a folder can hold can be written") {
    const TemporaryFolder folder;
    const std::string name(255, 'x');
    CHECK(write_file_atomically(folder / name, "1").empty());
    CHECK_THAT(write_file_atomically(folder / (name + "x"), "1"), ContainsSubstring("too long"));
    CHECK(folder.names() == std::vector<std::string>{name});
}

TEST_CASE("a place that is no place for a file is refused with its path and the reason") {
    const TemporaryFolder folder;
    put(folder / "file", "kept");
    const auto error = [&](const std::string& name) {
        return write_file_atomically(folder / name, "new");
    };
    CHECK(error("none/f") ==
          (folder / "none/f") + ": cannot be written: No such file or directory");
    CHECK_THAT(error("."), ContainsSubstring("Is a directory"));
    CHECK_THAT(error("file/f"), ContainsSubstring("Not a directory"));
    CHECK(content_of(folder / "file") == "kept");
    CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a folder or file without write permission stays as it is", "[needs_ordinary_user]") {
    const OrdinaryUser user;
    SKIP_UNLESS(::geteuid() != 0, "root cannot become another user here");
    const TemporaryFolder folder;
    put(folder / "file", "kept");
    ::chmod((folder / "file").c_str(), 0444);
    CHECK_THAT(write_file_atomically(folder / "file", "new"),
               ContainsSubstring("Permission denied"));
    ::chmod((folder / ".").c_str(), 0555);
    CHECK_THAT(write_file_atomically(folder / "other", "new"),
               ContainsSubstring("Permission denied"));
    ::chmod((folder / ".").c_str(), 0755);
    CHECK(content_of(folder / "file") == "kept");
    CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("another user's file that may be written, but not replaced, is written",
          "[needs_ordinary_user]") {
    SKIP_UNLESS(::geteuid() == 0, "only root can give a folder to another user");
    const TemporaryFolder folder;
    put(folder / "file", std::string(1000, 'x'));
    ::chmod((folder / "file").c_str(), 0666);
    ::chmod((folder / ".").c_str(), 01777);
    const OrdinaryUser user;
    SKIP_UNLESS(::geteuid() != 0, "root cannot become another user here");
    CHECK(write_file_atomically(folder / "file", "new").empty());
    CHECK(content_of(folder / "file") == "new");
    CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a disk that fills up leaves the old file and no temporary one") {
    const TemporaryFolder folder;
    put(folder / "f", "old");
    const std::string big(10000, 'x');
    std::string error, error_of_new;
    {
        const SmallDisk disk(4096);
        error = write_file_atomically(folder / "f", big);
        error_of_new = write_file_atomically(folder / "g", big);
    }
    CHECK_THAT(error, ContainsSubstring("File too large"));
    CHECK_THAT(error_of_new, ContainsSubstring("File too large"));
    CHECK(content_of(folder / "f") == "old");
    CHECK(folder.names() == std::vector<std::string>{"f"});
}

TEST_CASE("devices are written in place, not replaced") {
    const TemporaryFolder folder;
    fs::create_symlink("/dev/full", folder / "full");
    CHECK_THAT(write_file_atomically(folder / "full", "x"), ContainsSubstring("No space left"));
    CHECK(write_file_atomically("/dev/null", "x").empty());
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("temporary files of others, such as a process of the same number elsewhere, are let be") {
    const TemporaryFolder folder;
    const std::string prefix = ".etalon-" + std::to_string(::getpid()) + "-";
    constexpr std::size_t others = 2000;  // more than this program makes
    for (std::size_t i = 0; i < others; ++i)
        put(folder / (prefix + std::to_string(i) + ".tmp"), "");
    CHECK(write_file_atomically(folder / "f", "1").empty());
    CHECK(content_of(folder / "f") == "1");
    CHECK(folder.names().size() == others + 1);
}

TEST_CASE(
    "a file that the program itself is writing is replaced, not taken for a redirected stream") {
    const TemporaryFolder folder;
    const std::string path = folder / "f";
    const int flags = GENERATE(0, O_CLOEXEC);
    const int own = ::open(path.c_str(), O_WRONLY | O_CREAT | flags, 0666);
    REQUIRE(own >= 0);
    REQUIRE(own <= 9);  // as those that a shell redirects
    CHECK(write_all(own, "earlier") == 0);
    CHECK(write_file_atomically(path, "later").empty());
    CHECK(close_file(own) == 0);
    CHECK(content_of(path) == "later");
}

TEST_CASE("concurrent writers do not collide, and readers always find a whole file") {
    const TemporaryFolder folder;
    const std::string path = folder / "f";
    constexpr int writers = 4, rounds = 20;
    constexpr std::size_t size = 50000;
    put(path, std::string(size, 'a'));
    std::atomic<int> running = writers;
    std::array<std::string, writers> errors;
    std::vector<std::thread> threads;
    for (std::size_t w = 0; w < writers; ++w) {
        threads.emplace_back([&, w] {
            const std::string content(size, static_cast<char>('a' + w));
            for (int i = 0; i < rounds; ++i) errors[w] += write_file_atomically(path, content);
            --running;
        });
    }
    int torn = 0;
    while (running > 0) {
        const std::string seen = content_of(path);
        torn += seen.size() != size || seen != std::string(size, seen[0]);
    }
    for (std::thread& t : threads) t.join();
    CHECK(errors == std::array<std::string, writers>());
    CHECK(torn == 0);
    CHECK(folder.names() == std::vector<std::string>{"f"});
}
