// Numbers are compared with std::from_chars, bit by bit, for each instruction set.
#include <bit>
#include <charconv>
#include <cstdint>
#include <string>

#include "core/formats/number.h"
#include "core/formats/number_list.h"
#include "core/numerics/instruction_sets.h"
#include "core/numerics/random.h"
#include "tests/each_instruction_set.h"

using namespace etalon;

namespace {

std::string random_digits(Random& random, std::size_t count) {
    std::string digits(count, '0');
    for (char& c : digits) c = static_cast<char>('0' + random.index(10));
    return digits;
}

std::string formatted(const char* format, double value) {
    char text[512];
    return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, format, value))};
}

/// Returns a number as programs print it to scene files.
std::string printed(Random& random) {
    static constexpr const char* formats[] = {"%.6f", "%g",    "%.9g", "%.3f",
                                              "%.0f", "%.17g", "%.4e"};
    const double scale = random.index(4) == 0 ? 1e5 : 1;
    return formatted(formats[random.index(7)], (random.uniform() - 0.5) * scale);
}

/// Returns digits with an optional point anywhere and an optional exponent.
std::string anything(Random& random) {
    std::string text = random_digits(random, 1 + random.index(random.index(8) == 0 ? 40 : 17));
    if (random.index(4) != 0)
        text.insert(random.index(static_cast<unsigned>(text.size()) + 1), ".");
    if (random.index(3) == 0) {
        const unsigned size = random.index(random.index(4) == 0 ? 340 : 30);
        text += (random.index(2) ? "e" : "E") + std::string(random.index(2) ? "-" : "") +
                std::to_string(size);
    }
    return text;
}

/// Returns a number half way between two floats or two doubles, or one that differs from it in a
/// digit far to the right.
std::string half_way(Random& random) {
    std::uint64_t bits = random.bits() & 0x7FFFFFFFFFFFFFFF;
    if (random.index(2) == 0) bits = (bits & ~std::uint64_t{0x1FFFFFFF}) | 0x10000000;
    const std::uint64_t exponent = 1023 - 40 + random.index(80);
    bits = (bits & 0x000FFFFFFFFFFFFF) | exponent << 52;
    std::string text = formatted("%.120f", std::bit_cast<double>(bits));
    text.resize(text.find_last_not_of('0') + 1);
    const unsigned which = random.index(3);
    if (which == 1) text += "0000000000000001";
    if (which == 2 && text.back() != '.')
        --text.back();  // not a 0, since trailing zeros are removed
    return text;
}

/// Returns whether `text` is read as std::from_chars reads it.
template <class T>
bool agrees(const std::string& text, const std::string& rest) {
    const std::string_view unsigned_text = std::string_view(text).substr(text[0] == '+');
    const char* const end = unsigned_text.data() + unsigned_text.size();
    T expected = 0, value = 0;
    const auto [behind, error] = std::from_chars(unsigned_text.data(), end, expected);
    const std::string whole = text + rest;
    const ScannedNumber scanned = scan_number(whole.data(), whole.data() + whole.size(), value);
    if (error == std::errc::result_out_of_range) return true;  // number_test.cpp has those
    return error == std::errc() && behind == end && scanned.status == NumberStatus::ok &&
           scanned.end == whole.data() + text.size() &&
           std::memcmp(&value, &expected, sizeof value) == 0;
}

template <class Make>
void check_numbers(int count, std::uint64_t seed, const Make& make) {
    test::for_each_target([&] {
        Random random(seed);
        for (int i = 0; i < count; ++i) {
            std::string text = make(random);
            const unsigned sign = random.index(4);
            if (sign < 2 && text[0] != '-') text.insert(0, sign == 0 ? "-" : "+");
            const std::string rest = random.index(2) ? " -1.25 7\n3 0.5e3 1 1 1 1 1 1" : "";
            if (agrees<double>(text, rest) && agrees<float>(text, rest)) continue;
            FAIL_CHECK(text << rest);
        }
    });
}

}  // namespace

TEST_CASE("numbers as programs print them are read to the nearest") {
    check_numbers(400000, 1, printed);
}

TEST_CASE("numbers of any digits are read to the nearest") {
    check_numbers(500000, 2, anything);
}

TEST_CASE("numbers half way between two are read to the nearest") {
    check_numbers(100000, 3, half_way);
}

TEST_CASE("what ends a number may be any character at any place of it") {
    test::for_each_target([] {
        const std::string digits = "-123.4567e12";
        for (std::size_t size = 1; size <= digits.size(); ++size) {
            for (int c = 0; c < 256; ++c) {
                if (c >= '0' && c <= '9') continue;
                const std::string text =
                    digits.substr(0, size) + static_cast<char>(c) + "x" + std::string(40, '9');
                double expected = 0, value = 0;
                const auto [behind, error] =
                    std::from_chars(text.data(), text.data() + text.size(), expected);
                const ScannedNumber scanned =
                    scan_number(text.data(), text.data() + text.size(), value);
                const bool is_number = error == std::errc() && std::isfinite(expected);
                CAPTURE(text);
                REQUIRE((scanned.status == NumberStatus::ok) == is_number);
                if (!is_number) continue;
                REQUIRE(scanned.end == behind);
                REQUIRE(value == expected);
            }
        }
    });
}

TEST_CASE("a list of numbers has those that are read one by one") {
    test::for_each_target([] {
        Random random(4);
        for (const unsigned count : {0U, 1U, 7U, 1000U, 40000U}) {
            std::string text = count % 2 ? " # first\n" : "";
            std::vector<float> floats;
            std::vector<double> doubles;
            for (unsigned i = 0; i < count; ++i) {
                const std::string number = printed(random);
                static constexpr const char* blanks[] = {" ", "\n", "\r\n", "\t ", " # no 1 2\n "};
                text += number + blanks[random.index(5)];
                floats.push_back(std::stof(number));
                doubles.push_back(std::stod(number));
            }
            std::vector<float> read_floats{5};
            std::vector<double> read_doubles;
            const char* p = text.data();
            read_numbers(p, text.data() + text.size(), read_floats);
            CHECK(p == text.data() + text.size());
            floats.insert(floats.begin(), 5);
            CHECK((read_floats == floats));
            p = text.data();
            read_numbers(p, text.data() + text.size(), read_doubles);
            CHECK((read_doubles == doubles));
        }
    });
}

TEST_CASE("a list of integers cuts off what is behind a point") {
    const std::string text = "1 -2 3.99 -4.5 2147483647.5 -2147483648.5 1e3 12]";
    std::vector<std::int32_t> values;
    const char* p = text.data();
    read_numbers(p, text.data() + text.size(), values);
    CHECK(values == std::vector<std::int32_t>{1, -2, 3, -4, 2147483647, -2147483647 - 1, 1000, 12});
    CHECK(*p == ']');
}

TEST_CASE("a list of numbers ends before what is none") {
    for (const std::string rest :
         {"]", "\"x\" 1", "1abc 2", "x", "-", "nan", "inf", "1e400 3", "1#"}) {
        for (const std::string padding : {"", "                                   "}) {
            const std::string text = "1 2.5 3 " + rest + padding;
            CAPTURE(text);
            std::vector<float> values;
            const char* p = text.data();
            read_numbers(p, text.data() + text.size(), values);
            CHECK(values == std::vector<float>{1, 2.5F, 3});
            CHECK(p == text.data() + 8);
        }
    }
    std::vector<std::int32_t> integers;
    const std::string text = "7 3000000000 4";
    const char* p = text.data();
    read_numbers(p, text.data() + text.size(), integers);
    CHECK(integers == std::vector<std::int32_t>{7});
}
