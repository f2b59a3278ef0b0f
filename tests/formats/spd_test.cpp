#include "core/formats/spectrum/read_spectrum.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

struct Read {
    std::vector<SpectralSample> samples;
    std::vector<std::string> messages;
};

Read read(const std::string& text) {
    DiagnosticLog log("a.spd", text, false);
    Read r{read_spectrum(text, log), {}};
    for (const Diagnostic& d : log.take()) r.messages.push_back(to_string(d));
    return r;
}

/// The samples as one list: wavelength, value, wavelength, ...
std::vector<double> numbers(const Read& r) {
    std::vector<double> list;
    for (const auto& [wavelength, value] : r.samples) list.insert(list.end(), {wavelength, value});
    return list;
}

using Numbers = std::vector<double>;
using Messages = std::vector<std::string>;

}  // namespace

TEST_CASE("pairs of a wavelength and a value are read, comments are not") {
    const Read r = read("# Cu\r\n400 1.5 # violet 3\n700\t.25e1 550\n-1");
    CHECK(numbers(r) == Numbers{400, 1.5, 700, 2.5, 550, -1});
    CHECK(r.messages.empty());
    CHECK(numbers(read("")).empty());
}

TEST_CASE("what is between the numbers of a spectrum is passed over with a warning") {
    const Read r = read("400, 1\nnm 500 2\n600;3");
    CHECK(numbers(r) == Numbers{400, 1, 500, 2, 600, 3});
    CHECK(r.messages ==
          Messages{"a.spd:1:4: warning: passed over what is not a number in '400,'",
                   "a.spd:2:1: warning: passed over what is not a number in 'nm'",
                   "a.spd:3:4: warning: passed over what is not a number in '600;3'"});
}

TEST_CASE("a number of a spectrum without a partner is left out") {
    const Read r = read("400 1\n500");
    CHECK(numbers(r) == Numbers{400, 1});
    CHECK(r.messages == Messages{"a.spd:2:1: warning: the last number is left out: expected pairs "
                                 "of a wavelength and a value"});
}

TEST_CASE("a pair of a spectrum that no float holds is left out") {
    const Read r = read("400 1\n500 1e400\n1e39 2\n600 3\n");
    CHECK(numbers(r) == Numbers{400, 1, 600, 3});
    CHECK(r.messages == Messages{"a.spd:2:1: warning: pair left out: a number of it is too large",
                                 "a.spd:3:1: warning: pair left out: a number of it is too large"});
}

TEST_CASE("a damaged spectrum gives numbers that a float holds") {
    std::string text;
    for (int i = 0; i < 20; ++i) text += std::to_string(400 + i) + " 1.5e-3 # half\n";
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = text;
        for (unsigned k = 0; k <= random.index(8); ++k) {
            damaged[random.index(damaged.size())] ^= static_cast<char>(1U << random.index(8));
        }
        for (const double value : numbers(read(damaged))) REQUIRE(std::abs(value) < 3.5e38);
    }
}
