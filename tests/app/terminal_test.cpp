// Progress on a terminal.
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/common/progress_line.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Runs a shell command on a terminal of so many columns and returns its output.
std::string shown_on_terminal(const std::string& command, unsigned short columns) {
    const winsize size{24, columns, 0, 0};
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
    if (child == 0) {
        setenv("TERM", "xterm", 1);
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    std::string text;
    char buffer[4096];
    for (ssize_t n = 0; (n = read(terminal, buffer, sizeof buffer)) > 0;) {
        text.append(buffer, static_cast<std::size_t>(n));
    }
    waitpid(child, nullptr, 0);
    close(terminal);
    return text;
}

/// Returns the progress bars in a terminal's output, each from its carriage return on.
std::vector<std::string> bars_in(const std::string& text) {
    std::vector<std::string> bars;
    const std::string clear_rest = "\x1b[K";
    for (std::size_t at = 0; (at = text.find('\r', at)) != std::string::npos;) {
        const std::size_t end = text.find(clear_rest, ++at);
        if (end == std::string::npos) break;
        const std::string bar = text.substr(at, end - at);
        if (bar.find(" s left") != std::string::npos) bars.push_back(bar);
    }
    return bars;
}

}  // namespace

TEST_CASE("A terminal gets no bytes of an image, but a sentence", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string command = "cd '" + f.path("") + "'; '" ETALON_BINARY_DIR "/bin/etalon' ";
    const std::string shown = shown_on_terminal(command + "render ball.p3f -o -; echo $?", 80);
    CHECK(shown ==
          "etalon: error: -o -: standard output is a terminal, which shows no image; "
          "expected a pipe or a file\r\n2\r\n");
}

TEST_CASE("A long text is shortened in its middle, between characters", "[app]") {
    CHECK(shortened("scene.p3f", 9) == "scene.p3f");
    CHECK(shortened("a/long/way/to/scene.p3f", 15) == "a/lo...cene.p3f");
    CHECK(shortened("éééééééééé", 7) == "é...ééé");
    CHECK(shortened("漢漢漢漢漢漢", 10) == "漢...漢漢");
    CHECK(shortened("two\nlines\x1b[2J", 40) == "two?lines?[2J");
    CHECK(shortened("scene.p3f", 3) == "...");
    CHECK(shortened("scene.p3f", 0) == "");
}

TEST_CASE("A line of progress fits any width and keeps the figures longest", "[app]") {
    const std::string path = "some/folder/" + std::string(300, 'x') + "/scene.p3f";
    for (int columns = 0; columns < 200; ++columns) {
        CHECK(progress_line(path, 0.5, 12, columns).size() <= static_cast<std::size_t>(columns));
        CHECK(progress_line("a.p3f", 1, 12, columns).size() <= static_cast<std::size_t>(columns));
    }
    CHECK(progress_line("a.p3f", 0.5, 12, 80) ==
          "a.p3f [###############...............]  50 %  12.0 s, 12 s left");
    CHECK(progress_line(path, 0.5, 12, 40) == "some...cene.p3f  50 %  12.0 s, 12 s left");
    CHECK(progress_line(path, 0.5, 12, 28) == "  50 %  12.0 s, 12 s left");
}

TEST_CASE("The progress bar of a scene with a long path stays on one line", "[app]") {
    const Folder f;
    const std::string folder = std::string(150, 'a') + '/' + std::string(150, 'b');
    std::filesystem::create_directories(f.path(folder));
    f.write(folder + "/ball.p3f", small_scene);
    const std::string text = shown_on_terminal(
        "cd '" + f.path("") + "' && exec '" ETALON_BINARY_DIR "/bin/etalon' render " + folder +
            "/ball.p3f --spp 10000000 --time-limit 0.5 -o a.exr",
        60);
    const std::vector<std::string> bars = bars_in(text);
    REQUIRE_FALSE(bars.empty());
    for (const std::string& bar : bars) {
        CHECK(bar.size() < 60);
        CHECK_THAT(bar, ContainsSubstring("/ball.p3f ["));
    }
}

TEST_CASE("Progress: given a terminal that moves no cursor, then there is no bar", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string text = shown_on_terminal(
        "cd '" + f.path("") +
            "' && TERM=dumb exec '" ETALON_BINARY_DIR
            "/bin/etalon' render ball.p3f --spp 10000000 --time-limit 0.5 -o a.exr",
        80);
    CHECK_THAT(text, !ContainsSubstring("\x1b") && ContainsSubstring("-> a.exr"));
}
