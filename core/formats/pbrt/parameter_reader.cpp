#include "core/formats/pbrt/parameter_reader.h"

#include <cmath>
#include <limits>

#include "core/formats/diagnostic_log.h"

namespace etalon::pbrt {

void warn_of_extra(const LooseNumber& number, std::string_view word, FileLoc loc, Log& log) {
    const std::string_view kept = word.substr(0, word.size() - number.extra.size());
    log.warn(loc, "number", "{} is read as {}: the rest is ignored", in_quotes(word),
             in_quotes(kept));
}

bool ParameterReader::fail(std::string_view expected) {
    const FileLoc loc = tokens_.loc();
    log_.fatal(loc, "syntax", "expected {} for '{}' of '{}', found {}", expected, given_.name,
               directive_, describe(tokens_.peek()));
    return false;
}

bool ParameterReader::read(ParameterList& list) {
    given_ = {};
    numbers_.clear();
    integers_.clear();
    strings_.clear();
    given_.where = tokens_.loc();
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
    if (!number) return fail("a number");
    const FileLoc loc = tokens_.loc();
    if (!number->extra.empty()) warn_of_extra(*number, word, loc, log_);
    add_number(*number, loc);
    tokens_.next();
    return true;
}

void ParameterReader::add_number(const LooseNumber& number, FileLoc loc) {
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
    if (!is_finite && given_.not_finite.line == 0) given_.not_finite = loc;
}

}  // namespace etalon::pbrt
