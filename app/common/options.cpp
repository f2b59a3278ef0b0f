#include "app/common/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "app/common/without_repeats.h"
#include "core/base/parse_number.h"
#include "core/formats/nearest_name.h"

namespace etalon {
namespace {

template <class T>
struct ValueOf {
    using type = T;
};
template <class T>
struct ValueOf<std::vector<T>> {
    using type = T;
};
template <class T>
struct ValueOf<std::optional<T>> {
    using type = T;
};

/// Returns the variable if it takes several values.
template <class T>
ValueList list_of(T& value) {
    if constexpr (std::is_constructible_v<ValueList, T*>) return &value;
    return {};
}

template <class T>
constexpr bool is_whole = std::is_integral_v<T>;

/// Reads a number: CLI11 would take -1 for the largest unsigned one, and 010 for 8.
template <class T>
std::optional<T> parse(const std::string& text) {
    if constexpr (is_whole<T>) {
        return parse_number<T>(text);
    } else {
        T value{};
        return CLI::detail::lexical_cast(text, value) ? std::optional(value) : std::nullopt;
    }
}

/// Removes the leading zeros of a whole number, for CLI11, to which they mean octal numbers.
std::string without_leading_zeros(std::string text) {
    const std::size_t sign = text.starts_with('-') ? 1 : 0;
    const std::size_t first = text.find_first_not_of('0', sign);
    const bool is_zero = first == std::string::npos && text.size() > sign;
    const bool has_more = first != std::string::npos && first > sign && std::isdigit(text[first]);
    if (is_zero) return "0";
    return has_more ? text.erase(sign, first - sign) : text;
}

/// Returns "TEXT: expected ..." unless the text is a number that `accepts`.
template <class T, class Test>
auto number_check(const std::string& expected, Test accepts) {
    return [=](const std::string& text) {
        const std::optional<T> value = parse<T>(text);
        return value && accepts(*value) ? std::string() : text + ": expected " + expected;
    };
}

template <class T>
auto range_check(T least, T most) {
    const char* what = is_whole<T> ? "a whole number" : "a number";
    return number_check<T>(fmt::format("{} from {} to {}", what, least, most),
                           [=](T value) { return least <= value && value <= most; });
}

/// Name of the check that a narrower one replaces.
constexpr const char* any_number = "any number";

/// Accepts everything that T can hold except NaN.
template <class T>
CLI::Validator any_check() {
    std::string expected = "a number";
    if constexpr (is_whole<T>) {
        using Limits = std::numeric_limits<T>;
        expected = fmt::format("a whole number from {} to {}", Limits::min(), Limits::max());
    }
    const auto is_number = [](T x) {
        if constexpr (is_whole<T>) return true;
        return !std::isnan(static_cast<double>(x));
    };
    return CLI::Validator(number_check<T>(expected, is_number), "", any_number);
}

}  // namespace

Option& Option::value(const std::string& name) {
    option_->type_name(name);
    return *this;
}

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::value_or(const std::string& usual) {
    option_->expected(0, 1)->default_str(usual)->type_name("[" + option_->get_type_name() + "]");
    return *this;
}

Option& Option::by_commas() {
    return words_by_commas().each_once();
}

Option& Option::words_by_commas() {
    option_->delimiter(',')->type_name(option_->get_type_name() + ",...");
    return one_value_each();
}

Option& Option::each_once() {
    when_parsed_->emplace_back([list = list_] {
        const auto shorten = [](auto* values) { *values = without_repeats(*values); };
        if (const auto* numbers = std::get_if<std::vector<int>*>(&list)) shorten(*numbers);
        if (const auto* texts = std::get_if<std::vector<std::string>*>(&list)) shorten(*texts);
    });
    return *this;
}

Option& Option::one_value_each() {
    option_->allow_extra_args(false);
    return *this;
}

Option& Option::excludes(const std::string& other) {
    option_->excludes(other);
    return *this;
}

Option& Option::show_default() {
    option_->capture_default_str();
    return *this;
}

Option& Option::group(const std::string& heading) {
    option_->group(heading);
    return *this;
}

Option& Option::suggest(const std::vector<std::string>& values) {
    (*choices_)[option_] = values;
    return *this;
}

Option& Option::one_of(const std::vector<std::string>& values) {
    suggest(values);
    const std::string list = fmt::format("{}", fmt::join(values, ", "));
    return explain("One of " + list).check([values, list](const std::string& text) {
        if (std::ranges::find(values, text) != values.end()) return std::string();
        const std::vector<std::string_view> names(values.begin(), values.end());
        return text + ": expected one of " + list + did_you_mean(text, names);
    });
}

Option& Option::within(int least, int most) {
    return within_range(least, most);
}

Option& Option::within(std::size_t least, std::size_t most) {
    return within_range(least, most);
}

Option& Option::within(double least, double most) {
    return within_range(least, most);
}

Option& Option::positive() {
    return explain("Above 0").narrow(
        number_check<double>("a number above 0", [](double x) { return x > 0; }));
}

Option& Option::not_negative() {
    return explain("0 or above").narrow(number_check<double>("0 or a number above", [](double x) {
        return x >= 0;
    }));
}

Option& Option::explain(const std::string& rule) {
    option_->description(option_->get_description() + ". " + rule);
    return *this;
}

template <class T>
Option& Option::within_range(T least, T most) {
    return explain(fmt::format("{} to {}", least, most)).narrow(range_check(least, most));
}

Option& Option::narrow(std::function<std::string(const std::string&)> find_error) {
    option_->get_validator(any_number)->active(false);
    return check(std::move(find_error));
}

Option& Option::check(std::function<std::string(const std::string&)> find_error) {
    option_->check(std::move(find_error));
    return *this;
}

template <class T>
Option Options::add(const std::string& names, T& value, const std::string& help) {
    using Value = typename ValueOf<T>::type;
    CLI::Option* const option = app_.add_option(names, value, help);
    if constexpr (std::is_arithmetic_v<Value>) {
        option->type_name(is_whole<Value> ? "N" : "X");
        option->check(any_check<Value>());
        if constexpr (is_whole<Value>) option->transform(without_leading_zeros);
    } else {
        option->type_name("NAME");
        option->check([](const std::string& text) {
            return text.empty() ? "'': expected a value" : std::string();
        });
    }
    return {*option, choices_, when_parsed_, list_of(value)};
}

template Option Options::add(const std::string&, int&, const std::string&);
template Option Options::add(const std::string&, unsigned&, const std::string&);
template Option Options::add(const std::string&, std::size_t&, const std::string&);
template Option Options::add(const std::string&, double&, const std::string&);
template Option Options::add(const std::string&, std::string&, const std::string&);
template Option Options::add(const std::string&, std::vector<int>&, const std::string&);
template Option Options::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option Options::add(const std::string&, std::optional<std::int64_t>&, const std::string&);

Option Options::add_flag(const std::string& names, bool& value, const std::string& help) {
    return {*app_.add_flag(names, value, help), choices_, when_parsed_, {}};
}

void Options::add_notes(const std::string& text) {
    app_.footer(text);
}

}  // namespace etalon
