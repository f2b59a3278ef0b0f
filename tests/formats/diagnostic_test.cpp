#include "core/formats/diagnostic.h"

#include <algorithm>
#include <string>

#include "core/formats/diagnostic_log.h"
#include "core/formats/locator.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

Diagnostic warning(const std::string& kind, int line) {
    return {Severity::warning, kind, "f", line, 2, std::string("m").append(std::to_string(line))};
}

std::size_t lines_of(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void check_place(Locator& locator, std::size_t offset, int line, int column) {
    CAPTURE(offset);
    const TextPosition p = locator.locate(offset);
    CHECK(p.line == line);
    CHECK(p.column == column);
}

}  // namespace

TEST_CASE("a diagnostic is written as FILE:LINE:COLUMN") {
    CHECK(to_string({Severity::error, "k", "a.p3f", 3, 7, "no"}) == "a.p3f:3:7: error: no");
    CHECK(to_string({Severity::warning, "k", "a.p3f", 0, 0, "no"}) == "a.p3f: warning: no");
}

TEST_CASE("a diagnostic is one line of bounded length, whatever names are in it") {
    CHECK(to_string({Severity::error, "k", "a\n\x1B[31m", 3, 7, "'\b\r\x7F\t\xC2\x9B' \xC3\xA9"}) ==
          "a\\x0a\\x1b[31m:3:7: error: '\\x08\\x0d\\x7f\\x09\\xc2\\x9b' \xC3\xA9");
    const std::string large(1'000'000, '\n');
    CHECK(to_string({Severity::error, "k", large, 3, 7, large}).size() < 4000);
}

TEST_CASE("a report shows at most so many of a kind and counts the rest") {
    std::vector<Diagnostic> list;
    for (int i = 1; i <= 25; ++i) list.push_back(warning("a", i));
    list.push_back(warning("b", 99));
    const std::string text = report(list);
    CHECK(lines_of(text) == 22);
    CHECK(
        text.find(
            "f:20:2: warning: m20\nf:99:2: warning: m99\nf: warning: 5 more of this kind (a)\n") !=
        text.npos);
    CHECK(report(list, 1) ==
          "f:1:2: warning: m1\nf:99:2: warning: m99\nf: warning: 24 more of this kind (a)\n");
    CHECK(report({}).empty());
}

TEST_CASE("a report counts what a log did not keep") {
    const std::string text(1000, '\n');
    DiagnosticLog log("f", text, false);
    for (std::size_t i = 0; i < 1000; ++i) log.warn(i, "k", "m{}", i);
    const std::vector<Diagnostic> kept = log.take();
    CHECK(kept.size() == 20);
    CHECK(lines_of(report(kept)) == 21);
    CHECK(report(kept).ends_with("f:20:1: warning: m19\nf: warning: 980 more of this kind (k)\n"));
}

TEST_CASE("no number of warnings hides an error of the same kind") {
    DiagnosticLog log("f", "", false);
    for (int i = 0; i < 22; ++i) log.warn(DiagnosticLog::whole_file, "k", "m{}", i);
    log.error(DiagnosticLog::whole_file, "k", "the error");
    CHECK(report(log.take())
              .ends_with(
                  "f: warning: m19\nf: error: the error\nf: warning: 2 more of this kind (k)\n"));
}

TEST_CASE("a strict log makes errors of warnings") {
    DiagnosticLog tolerant("f", "abc", false), strict("f", "abc", true);
    tolerant.warn(0, "k", "m");
    strict.warn(0, "k", "m");
    CHECK_FALSE(tolerant.has_errors());
    CHECK(strict.has_errors());
    CHECK(strict.take()[0].severity == Severity::error);
}

TEST_CASE("a message about the file as a whole has no line") {
    DiagnosticLog log("f", "abc", false);
    log.error(DiagnosticLog::whole_file, "k", "m");
    CHECK(log.take()[0].line == 0);
}

TEST_CASE("places are found in any order") {
    Locator locator("ab\nc\r\n\nlong line");
    check_place(locator, 0, 1, 1);
    check_place(locator, 2, 1, 3);
    check_place(locator, 3, 2, 1);
    check_place(locator, 12, 4, 6);
    check_place(locator, 16, 4, 10);
    check_place(locator, 8, 4, 2);
    check_place(locator, 6, 3, 1);
    check_place(locator, 1, 1, 2);
    check_place(locator, 7, 4, 1);
}

TEST_CASE("places are found where lines end with CR alone") {
    Locator locator("ab\rc\r\rlong line");
    check_place(locator, 3, 2, 1);
    check_place(locator, 6, 4, 1);
    check_place(locator, 15, 4, 10);
    check_place(locator, 2, 1, 3);
}

TEST_CASE("places near each other and far from each other are found") {
    std::string text;
    for (int line = 1; line <= 300; ++line)
        text += std::string(static_cast<std::size_t>(line % 9), 'x') + "\n";
    Locator locator(text);
    for (const std::size_t offset : {0, 10, 11, 500, 1400, 1401, 3, 511, 1023, 1024, 1, 0}) {
        const std::string_view before = std::string_view(text).substr(0, offset);
        const auto start = static_cast<int>(before.rfind('\n') + 1);
        check_place(locator, offset,
                    static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
                    static_cast<int>(offset) - start + 1);
    }
}

TEST_CASE("a word in a message is printable and short") {
    CHECK(in_quotes("abc") == "'abc'");
    CHECK(in_quotes(std::string("a\0\xFF", 3)) == "'a\\x00\\xff'");
    CHECK(in_quotes(std::string(100, 'x')) == "'" + std::string(40, 'x') + "...'");
}

TEST_CASE("a path in a message is printable and whole") {
    const std::string path = "/" + std::string(300, 'x') + "/part.pbrt";
    CHECK(path_in_quotes(path) == "'" + path + "'");
    CHECK(path_in_quotes("a\x1b") == "'a\\x1b'");
    CHECK(path_in_quotes(std::string(5000, 'x')).size() < 4200);
}
