#include "core/formats/pbrt/lexer.h"

#include "core/formats/pbrt/number.h"
#include "tests/catch.h"

using namespace etalon::pbrt;

namespace {

/// Tokens as text: strings in quotes, the rest as it is.
std::vector<std::string> tokens(const std::string& text) {
    Lexer lexer(text);
    std::vector<std::string> list;
    for (Token t = lexer.next(); t.kind != TokenKind::end; t = lexer.next()) {
        const std::string word(t.text);
        list.push_back(t.kind == TokenKind::string      ? '"' + word + '"'
                       : t.kind == TokenKind::malformed ? "malformed"
                                                        : word);
    }
    return list;
}

using Words = std::vector<std::string>;

/// Nearest float of a word.
float read(const std::string& word) {
    const auto number = read_number(word);
    REQUIRE(number);
    return to_float(number->value, word.data(), word.data() + word.size());
}

}  // namespace

TEST_CASE("blanks, tabs, CR and LF separate tokens, and so do brackets and quotes") {
    CHECK(tokens("a b\tc\rd\ne") == Words{"a", "b", "c", "d", "e"});
    CHECK(tokens("a[1 2]b\"c\"d") == Words{"a", "[", "1", "2", "]", "b", "\"c\"", "d"});
    CHECK(tokens("a\vb\fc") == Words{"a\vb\fc"});
}

TEST_CASE("a byte order mark at the start of a file is no token") {
    CHECK(tokens("\xEF\xBB\xBF"
                 "a b") == Words{"a", "b"});
}

TEST_CASE("a comment starts where a token would, and ends with its line") {
    CHECK(tokens("# x\na # y [ \" \rb") == Words{"a", "b"});
    CHECK(tokens("a#b 1#c") == Words{"a#b", "1#c"});
    CHECK(tokens("\"a#b\"") == Words{"\"a#b\""});
}

TEST_CASE("a string has eight escapes and stays on its line") {
    CHECK(tokens(R"("\b\f\n\r\t\\\'\"")") == Words{"\"\b\f\n\r\t\\'\"\""});
    CHECK(tokens(R"("a\x")") == Words{"malformed"});
    CHECK(tokens("\"a\nb\"") == Words{"malformed", "b", "malformed"});
    CHECK(tokens("\"a") == Words{"malformed"});
    CHECK(tokens("\"a\\") == Words{"malformed"});
    CHECK(tokens("\"\"") == Words{"\"\""});
}

TEST_CASE("a token says where it begins") {
    Lexer lexer("  ab \"c\" ]");
    CHECK(lexer.next().offset == 2);
    CHECK(lexer.next().offset == 5);
    CHECK(lexer.next().offset == 9);
    CHECK(lexer.next().kind == TokenKind::end);
}

TEST_CASE("a run of numbers ends before the first token that is not simply one") {
    Lexer lexer("1 -2.5 # c\n 3e1]");
    std::vector<float> values;
    lexer.take_numbers(values);
    CHECK(values == std::vector{1.0F, -2.5F, 30.0F});
    CHECK(lexer.next().kind == TokenKind::close);
    for (const char* other : {"x", "1x", "nan", "1e400", "1e39", "\"1\"", "]", "[", ""}) {
        CAPTURE(other);
        const std::string text = std::string("7 ") + other;
        Lexer stops(text);
        values.clear();
        stops.take_numbers(values);
        CHECK(values == std::vector{7.0F});
        CHECK(stops.next().text == (*other == '"' ? "1" : other));
    }
}

TEST_CASE("a run of integers ends before one that is too large, and cuts fractions off") {
    for (const char* other : {"2147483648", "-2147483649", "1e10", "x"}) {
        const std::string text = std::string("-2147483648 2147483647 1.9 -1e3 ") + other;
        Lexer lexer(text);
        std::vector<std::int32_t> values;
        lexer.take_numbers(values);
        CHECK(values == std::vector{-2147483647 - 1, 2147483647, 1, -1000});
        CHECK(lexer.next().text == other);
    }
}

TEST_CASE("a number is what C's strtof makes of the word") {
    CHECK(read("1") == 1.0F);
    CHECK(read("+.5") == 0.5F);
    CHECK(read("5.") == 5.0F);
    CHECK(std::isinf(read("-1e400")));
    CHECK(std::isinf(read("INF")));
    CHECK(std::isnan(read("nan")));
    CHECK(read_number("1abc")->extra == "abc");
    CHECK(read_number("1.5.2")->extra == ".2");
    CHECK_FALSE(read_number("abc"));
    CHECK_FALSE(read_number("-"));
    CHECK_FALSE(read_number("."));
    CHECK_FALSE(read_number(""));
}

TEST_CASE("a number whose nearest double is halfway between floats is still the nearest float") {
    // 1 + 2^-24 lies between 1 and 1 + 2^-23; digits that a double cannot hold decide.
    CHECK(read("1.000000059604644775390625") == 1.0F);
    CHECK(read("1.00000005960464477539062500000000001") == std::nextafter(1.0F, 2.0F));
    CHECK(read("+1.00000005960464477539062500000000001") == std::nextafter(1.0F, 2.0F));
    CHECK(read("1e-45") == std::numeric_limits<float>::denorm_min());
}
