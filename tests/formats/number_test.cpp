#include "core/formats/number.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

template <class T>
struct Result {
    T value = 0;
    NumberStatus status = NumberStatus::malformed;
    std::string rest;
};

template <class T>
Result<T> scan(const std::string& text) {
    Result<T> r;
    const ScannedNumber s = scan_number(text.data(), text.data() + text.size(), r.value);
    r.status = s.status;
    if (s.status == NumberStatus::ok)
        r.rest = text.substr(static_cast<std::size_t>(s.end - text.data()));
    return r;
}

double value_of(const std::string& text) {
    const Result<double> r = scan<double>(text);
    CAPTURE(text);
    CHECK(r.status == NumberStatus::ok);
    CHECK(r.rest.empty());
    return r.value;
}

}  // namespace

TEST_CASE("every way to write a decimal number is read") {
    CHECK(value_of("5.") == 5.0);
    CHECK(value_of(".5") == 0.5);
    CHECK(value_of("+1") == 1.0);
    CHECK(value_of("-1") == -1.0);
    CHECK(value_of("1e-3") == 1e-3);
    CHECK(value_of("1E+3") == 1000.0);
    CHECK(value_of("5.e2") == 500.0);
    CHECK(value_of("007") == 7.0);
    CHECK(value_of("1.11022e-16") == 1.11022e-16);
    CHECK(value_of("0.1234567890123456789012345678901234567890") == 0.12345678901234567890123);
    CHECK(value_of("123456789012345678901234567890") == 123456789012345678901234567890.0);
    CHECK(value_of("9007199254740993") == 9007199254740992.0);
    CHECK(value_of("1e0000000000000000000000001") == 10.0);
}

TEST_CASE("zero keeps its sign") {
    CHECK(std::signbit(value_of("-0")));
    CHECK_FALSE(std::signbit(value_of("0")));
    CHECK(std::signbit(value_of("-1e-999")));
}

TEST_CASE("a number ends where it is no longer one") {
    CHECK(scan<double>("1.5abc").rest == "abc");
    CHECK(scan<double>("1e").rest == "e");
    CHECK(scan<double>("1e+").rest == "e+");
    CHECK(scan<double>("1.2.3").rest == ".3");
    CHECK(scan<double>("0x10").rest == "x10");
    CHECK(scan<std::int64_t>("12.5").rest == ".5");
}

TEST_CASE("what is not a number is malformed") {
    for (const char* text :
         {"", "+", "-", ".", "-.", "e5", ".e5", "--1", "abc", "nan", "inf", "-inf"}) {
        CAPTURE(text);
        CHECK(scan<double>(text).status == NumberStatus::malformed);
        CHECK(scan<std::int64_t>(text).status == NumberStatus::malformed);
    }
}

TEST_CASE("a number too large for double is out of range, one too small is zero") {
    for (const char* text : {"1e400", "-1e400", "1.8e308", "0.001e320", "1e99999999999999999999"}) {
        CAPTURE(text);
        CHECK(scan<double>(text).status == NumberStatus::out_of_range);
    }
    CHECK(scan<double>(std::string(400, '9')).status == NumberStatus::out_of_range);
    CHECK(scan<double>("1" + std::string(400, '0') + "e-50").status == NumberStatus::out_of_range);
    CHECK(value_of("1e-400") == 0.0);
    CHECK(value_of("12345e-400") == 0.0);
    CHECK(value_of("0e99999999999999999999") == 0.0);
    CHECK(value_of("0." + std::string(400, '0') + "1") == 0.0);
    CHECK(value_of("0." + std::string(400, '0') + "1e400") == 0.1);
    CHECK(value_of("1e-99999999999999999999") == 0.0);
    CHECK(value_of("5e-324") == 5e-324);
    CHECK(value_of("1.7976931348623157e308") == std::numeric_limits<double>::max());
}

TEST_CASE("zeros before an integer do not count") {
    CHECK(scan<std::int64_t>("00000000000000000000004").value == 4);
    CHECK(scan<std::int64_t>("-0000000000000009223372036854775807").value == -9223372036854775807);
    CHECK(scan<std::int64_t>("0000000000000000000000").value == 0);
    CHECK(scan<std::int64_t>("0000009223372036854775808").status == NumberStatus::out_of_range);
}

TEST_CASE("floats are rounded once, and end where floats do") {
    CHECK(scan<float>("16777217").value == 16777216.0F);  // between two floats, to the even one
    CHECK(scan<float>("16777219").value == 16777220.0F);
    CHECK(scan<float>("16777217.00000001").value == 16777218.0F);
    CHECK(scan<float>("16777217.00000000000000000000001").value == 16777218.0F);
    CHECK(scan<float>("16777216.99999999999999999999999").value == 16777216.0F);
    CHECK(scan<float>("3.4028235e38").value == std::numeric_limits<float>::max());
    CHECK(scan<float>("3.4028236e38").status == NumberStatus::out_of_range);
    CHECK(scan<float>("1e-45").value == std::numeric_limits<float>::denorm_min());
    CHECK(scan<float>("7e-46").value == 0);
    CHECK(scan<float>("1e-50").status == NumberStatus::ok);
    CHECK(std::signbit(scan<float>("-1e-50").value));
}

TEST_CASE("integers are read to the ends of their range") {
    CHECK(scan<std::int64_t>("9223372036854775807").value ==
          std::numeric_limits<std::int64_t>::max());
    CHECK(scan<std::int64_t>("-9223372036854775807").value ==
          -std::numeric_limits<std::int64_t>::max());
    CHECK(scan<std::int64_t>("9223372036854775808").status == NumberStatus::out_of_range);
    CHECK(scan<std::int64_t>("99999999999999999999").status == NumberStatus::out_of_range);
    CHECK(scan<std::int64_t>("+42").value == 42);
}
