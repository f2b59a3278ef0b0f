// Lists long enough to be read by several threads: one thread must read the same.
#include <string>

#include "core/formats/number_list.h"
#include "core/numerics/random.h"
#include "core/parallel/parallel.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr std::size_t bytes = 5 << 20;

/// Returns numbers, each followed by one of `blanks`. One in `rarity` blanks is replaced by `rare`.
std::string list_text(std::uint64_t seed, const std::vector<std::string>& blanks, unsigned rarity,
                      const std::string& rare) {
    Random random(seed);
    std::string text;
    while (text.size() < bytes) {
        text += std::to_string(static_cast<int>(random.index(2'000'000)) - 1'000'000);
        text += blanks[random.index(static_cast<std::uint32_t>(blanks.size()))];
        if (random.index(rarity) == 0) text += rare;
    }
    return text;
}

template <class T>
struct Read {
    std::vector<T> values;
    std::size_t end = 0;
    bool operator==(const Read&) const = default;
};

template <class T>
Read<T> read(const std::string& text, int threads) {
    const ThreadLimit limit(threads);
    Read<T> result;
    result.values.push_back(7);  // a list may be appended to another
    const char* p = text.data();
    read_numbers(p, text.data() + text.size(), result.values);
    result.end = static_cast<std::size_t>(p - text.data());
    return result;
}

void require_same(const std::string& text) {
    for (const int threads : {2, 5}) {
        REQUIRE((read<float>(text, threads) == read<float>(text, 1)));
        REQUIRE((read<std::int32_t>(text, threads) == read<std::int32_t>(text, 1)));
    }
}

}  // namespace

TEST_CASE("a long list is read alike by any number of threads") {
    require_same(list_text(1, {"\n"}, 1000, ""));
    require_same(list_text(2, {" "}, 1000, ""));
    require_same(list_text(3, {" ", "\r\n", "\t ", "\n\n"}, 1000, "") + "] 1 2 3");
}

TEST_CASE("comments do not mislead the threads that begin behind them") {
    std::string long_comment = "# ";
    for (int i = 0; i < 30'000; ++i) long_comment += "1 2 3 ";
    require_same(list_text(4, {" ", "\n"}, 100, "# 1 2 ] 3\n"));
    require_same(list_text(5, {" "}, 30'000, long_comment + "\n"));
    require_same(list_text(6, {" ", "\n"}, 30'000, long_comment + "\r"));
    require_same(list_text(7, {"\n"}, 30'000, long_comment + "\n"));
    require_same(list_text(8, {" "}, 1000, "") + long_comment);
}

TEST_CASE("a long list ends where one thread ends it") {
    for (const std::string rest : {"]", "nan ", "1e400 ", "\"x\" ", "1x ", "3000000000.5 "}) {
        CAPTURE(rest);
        const std::string text = list_text(9, {" ", "\n"}, 100'000, rest);
        require_same(text);
    }
    require_same(list_text(10, {"\n"}, 1'000'000, "") + std::string(bytes, '1'));
    require_same(std::string(20'000, '\n') + list_text(11, {"\n"}, 1'000'000, ""));
    require_same(list_text(12, {""}, 200'000, " ") + " 1");
}
