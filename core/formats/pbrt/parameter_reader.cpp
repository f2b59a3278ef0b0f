#include "core/formats/pbrt/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/formats/diagnostic_log.h"
#include "core/formats/pbrt/color_values.h"

namespace etalon::pbrt {
namespace {

constexpr std::string_view numbers_expected = "a number";

template <class T>
void drop_surplus(std::vector<T>& values, std::size_t multiple) {
    values.resize(values.size() - values.size() % multiple);
}

/// Frees what a long list has too much of.
template <class T>
void fit(std::vector<T>& values) {
    if (values.capacity() - values.size() > values.size() / 4) values.shrink_to_fit();
}

}  // namespace

void warn_of_extra(const LooseNumber& number, std::string_view word, Place place, Log& log) {
    const std::string_view kept = word.substr(0, word.size() - number.extra.size());
    log.warn(place, "number", "{} is read as {}: the rest is ignored", in_quotes(word),
             in_quotes(kept));
}

bool ParameterReader::fail(std::string_view expected) {
    const Place place = tokens_.place();
    log_.fatal(place, "syntax", "expected {} for '{}' of '{}', found {}", expected, given_.name,
               directive_, describe(tokens_.peek()));
    return false;
}

bool ParameterReader::read(ParameterList& list) {
    given_ = {};
    numbers_.clear();
    integers_.clear();
    strings_.clear();
    given_.where = tokens_.place();
    const std::string text(tokens_.next().text);
    const Declaration declaration = split_declaration(text);
    declared_ = find_declared_type(declaration.type);
    given_.name = declaration.name;
    if (!read_values()) return false;
    if (!declared_ || declaration.name.empty()) {
        return refuse("expected a type and a name, found {}; types are: {}", in_quotes(text),
                      declared_type_words()) ||
               true;
    }
    if (convert() && list.add(std::move(given_))) {
        log_.warn(list.parameters.back().where, "repeated",
                  "'{}' of '{}' is given again; the later value counts", declaration.name,
                  directive_);
    }
    return true;
}

bool ParameterReader::read_values() {
    if (tokens_.peek().kind != TokenKind::open) return read_value();
    tokens_.next();
    while (true) {
        take_numbers();
        if (tokens_.peek().kind == TokenKind::close) break;
        if (!read_value()) return false;
    }
    tokens_.next();
    return true;
}

/// Takes numbers in bulk, unless they would be mixed with strings.
void ParameterReader::take_numbers() {
    if (!strings_.empty()) return;
    if (declared_ && declared_->type == ValueType::integer) {
        tokens_.take_numbers(integers_);
    } else {
        tokens_.take_numbers(numbers_);
    }
}

bool ParameterReader::read_value() {
    const TokenKind kind = tokens_.peek().kind;
    if (kind == TokenKind::string) return read_string();
    if (kind == TokenKind::word) return read_number_word();
    return fail("a value");
}

bool ParameterReader::read_string() {
    if (!numbers_.empty() || !integers_.empty()) return fail("only numbers, as before");
    strings_.emplace_back(tokens_.next().text);
    return true;
}

bool ParameterReader::read_number_word() {
    const std::string_view word = tokens_.peek().text;
    if (word == "true" || word == "false") {
        return fail("\"true\" or \"false\" in quotes (without them only since version 4)");
    }
    if (!strings_.empty()) return fail("only strings, as before");
    const std::optional<LooseNumber> number = read_number(word);
    if (!number) return fail(numbers_expected);
    const Place place = tokens_.place();
    if (!number->extra.empty()) warn_of_extra(*number, word, place, log_);
    add_number(*number, place);
    tokens_.next();
    return true;
}

void ParameterReader::add_number(const LooseNumber& number, Place place) {
    const std::string_view word = tokens_.peek().text;
    const char* const last = word.data() + (word.size() - number.extra.size());
    const float value = to_float(number.value, word.data(), last);
    bool is_finite = std::isfinite(value);
    if (declared_ && declared_->type == ValueType::integer) {
        constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
        constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
        const double whole = std::trunc(number.value);
        is_finite = whole >= least && whole <= most;
        integers_.push_back(is_finite ? static_cast<std::int32_t>(whole) : 0);
    } else {
        numbers_.push_back(value);
    }
    if (!is_finite && given_.not_finite.line == 0) given_.not_finite = place;
}

bool ParameterReader::convert() {
    given_.type = declared_->type;
    given_.is_texture = declared_->encoding == Encoding::texture_name;
    const bool may_be_strings = declared_->takes_strings();
    const bool may_be_numbers = !may_be_strings;
    const bool may_be_files = declared_->encoding == Encoding::spectrum;
    if (may_be_strings && strings_.empty()) {
        return refuse("'{}' is a {} and takes strings, not numbers; it is left out", given_.name,
                      declared_->word);
    }
    if (may_be_numbers && !may_be_files && !strings_.empty()) {
        return refuse("'{}' is a {} and takes numbers, not strings; it is left out", given_.name,
                      declared_->word);
    }
    return strings_.empty() ? convert_numbers() : convert_strings();
}

bool ParameterReader::convert_strings() {
    if (given_.is_texture && strings_.size() != 1) {
        return refuse("'{}' takes the name of one texture, not {}; it is left out", given_.name,
                      strings_.size());
    }
    if (declared_->encoding == Encoding::flags) {
        convert_flags();
    } else if (declared_->encoding == Encoding::spectrum) {
        convert_spectrum_files();
    } else {
        given_.values = std::move(strings_);
    }
    return true;
}

void ParameterReader::convert_flags() {
    std::vector<std::int32_t> flags;
    for (const std::string& text : strings_) {
        if (text != "true" && text != "false") {
            log_.warn(given_.where, "choice", "'{}' is true or false; {} is taken for false",
                      given_.name, in_quotes(text));
        }
        flags.push_back(text == "true" ? 1 : 0);
    }
    given_.values = std::move(flags);
}

void ParameterReader::convert_spectrum_files() {
    std::vector<float> rgb;
    for (const std::string& name : strings_) {
        const Color c = spectra_.color(name, given_.where);
        rgb.insert(rgb.end(), {c.x, c.y, c.z});
    }
    given_.values = std::move(rgb);
}

bool ParameterReader::convert_numbers() {
    if (declared_->type == ValueType::integer) {
        fit(integers_);
        given_.values = std::move(integers_);
        return true;
    }
    const auto multiple = static_cast<std::size_t>(declared_->numbers);
    if (const std::size_t surplus = numbers_.size() % multiple; surplus != 0) {
        log_.warn(given_.where, "count",
                  "'{}' takes {} numbers a value; the last {} of {} is left out", given_.name,
                  multiple, surplus, numbers_.size());
        drop_surplus(numbers_, multiple);
    }
    if (declared_->encoding != Encoding::plain) {
        numbers_ = to_rgb(*declared_, std::move(numbers_));
        const bool is_finite =
            std::ranges::all_of(numbers_, [](float x) { return std::isfinite(x); });
        if (!is_finite && given_.not_finite.line == 0) given_.not_finite = given_.where;
    }
    fit(numbers_);
    given_.values = std::move(numbers_);
    return true;
}

}  // namespace etalon::pbrt
