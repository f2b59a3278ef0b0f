#include "core/formats/tokenizer.h"

#include <string>
#include <vector>

#include "tests/catch.h"

using namespace etalon;

namespace {

std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> list;
    for (Tokenizer t(text); !t.at_end();) list.emplace_back(t.next());
    return list;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("words are separated by any blanks and line ends") {
    CHECK(words("s 0\t1\r\n2\n\n  3 \v\f 4  ") == Words{"s", "0", "1", "2", "3", "4"});
    CHECK(words("last") == Words{"last"});
    CHECK(words("").empty());
    CHECK(words(" \r\n\t").empty());
    CHECK(words({}).empty());
}

TEST_CASE("a comment runs from # to the end of the line, wherever it starts") {
    CHECK(words("#one\ns 1 # two\r\n##three\n#\n2#four\n3 #") == Words{"s", "1", "2", "3"});
    CHECK(words("#one\rs 1 # two\r##three\r#\r2#four\r3 #") == Words{"s", "1", "2", "3"});
}

TEST_CASE("a string can be taken as one word, up to the quote that closes it on its line") {
    Tokenizer t("a \"b # c\"d [\"e f\"] \"\" \"g h\n i\"");
    for (const char* word : {"a", "\"b # c\"", "d", "[\"e f\"", "]", "\"\"", "\"g", "h", "i\""}) {
        CHECK(t.next_with_string() == word);
    }
    CHECK(t.at_end());
}

TEST_CASE("a line can be taken by itself") {
    Tokenizer t("\n# none\n a 1 # 2\r\n\nb\nc 4 5");
    Tokenizer line = t.take_line();
    CHECK(line.offset() == 9);
    CHECK(line.next() == "a");
    CHECK(line.next() == "1");
    CHECK(line.at_end());
    CHECK(t.take_line().peek() == "b");
    line = t.take_line();
    CHECK(line.next() == "c");
    CHECK(line.offset() == 23);
    CHECK(t.at_end());
    CHECK(t.take_line().at_end());
}

TEST_CASE("a line may end with LF, CRLF or CR") {
    for (const char* text : {"a 1\nb\n", "a 1\r\nb\r\n", "a 1\rb\r"}) {
        Tokenizer t(text);
        Tokenizer line = t.take_line();
        CHECK(line.next() == "a");
        CHECK(line.next() == "1");
        CHECK(line.at_end());
        CHECK(t.take_line().peek() == "b");
        CHECK(t.at_end());
    }
}

TEST_CASE("a byte order mark at the start is no word") {
    CHECK(words("\xEF\xBB\xBFs 1") == Words{"s", "1"});
}

TEST_CASE("a number is consumed only if the whole word is one") {
    double x = 0;
    Tokenizer t("1.5 2x 3");
    CHECK(t.number(x) == NumberStatus::ok);
    CHECK(x == 1.5);
    CHECK(t.number(x) == NumberStatus::malformed);
    CHECK(t.next() == "2x");
    CHECK(t.number(x) == NumberStatus::ok);
    CHECK(t.at_end());
    CHECK(t.number(x) == NumberStatus::malformed);
}

TEST_CASE("a number may be followed by a comment or the end") {
    std::int64_t n = 0;
    Tokenizer t("7#seven\n8");
    CHECK(t.number(n) == NumberStatus::ok);
    CHECK(n == 7);
    CHECK(t.number(n) == NumberStatus::ok);
    CHECK(n == 8);
    CHECK(t.at_end());
}

TEST_CASE("the offset is that of the next word") {
    Tokenizer t("  ab #c\n d");
    CHECK(t.offset() == 2);
    t.next();
    CHECK(t.offset() == 9);
    CHECK(t.remaining() == 1);
    t.next();
    CHECK(t.offset() == 10);
    CHECK(t.next().empty());
}

TEST_CASE("what sets out to be a number is told from other words") {
    for (const char* text : {"1", "-1", "0", "9", "+.5", ".5", "1x"})
        CHECK(Tokenizer(text).at_number());
    for (const char* text : {"", "s", "-", ".", "-x", "nan", "e5"})
        CHECK_FALSE(Tokenizer(text).at_number());
}
