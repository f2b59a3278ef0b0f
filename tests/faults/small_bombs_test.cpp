#include "tests/faults/small_bombs.h"

#include <fmt/format.h>

#include <chrono>

#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

namespace {

constexpr std::size_t most_bytes_of_a_bomb = 1024;
constexpr double most_memory = 1e9;

constexpr int watchdog_seconds = is_sanitized ? 600 : 60;

/// Renders without a limit of memory, as what a small scene takes should need none, but with one of
/// time, and a watchdog, which should never be needed.
ProgramResult rendered(const Folder& f, const SmallBomb& bomb) {
    f.write("bomb." + bomb.format, bomb.text);
    if (!bomb.file.empty()) f.write(bomb.file, bomb.bytes);
    return f.shell(fmt::format("exec timeout -s KILL {} '" ETALON_BINARY_DIR
                               "/bin/etalon' render bomb.{} -t 2 "
                               "--time-limit 0.2 -q -o rendered.exr",
                               watchdog_seconds, bomb.format));
}

/// Returns whether the program ended as it should where memory ends: a sanitizer's operator new
/// does not throw.
bool reports_an_error(const ProgramResult& r) {
    if (is_sanitized && ContainsSubstring("allocator is out of memory").match(r.err)) return true;
    return r.status == 3 && ContainsSubstring("error: ").match(r.err);
}

}  // namespace

TEST_CASE("A small scene that asks for too much gives an error or an image, soon", "[faults]") {
    for (const SmallBomb& bomb : small_bombs()) {
        CAPTURE(bomb.name, bomb.format);
        REQUIRE(bomb.text.size() <= most_bytes_of_a_bomb);
        REQUIRE(bomb.bytes.size() <= most_bytes_of_a_bomb);
        const Folder f;
        const auto begin = std::chrono::steady_clock::now();
        const ProgramResult r = rendered(f, bomb);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        CAPTURE(r.status, r.err, took.count(), r.peak_bytes);
        CHECK((r.status == 0 ? f.has("rendered.exr") : reports_an_error(r)));
        CHECK(static_cast<double>(r.peak_bytes) < most_memory);
    }
}
