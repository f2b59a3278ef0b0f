#include "core/formats/pbrt/statement_reader.h"

#include <cmath>

#include "core/formats/diagnostic_log.h"
#include "core/formats/pbrt/number.h"
#include "core/formats/pbrt/parameter_reader.h"

namespace etalon::pbrt {

void StatementReader::begin() {
    ok_ = true;
    where_ = tokens_.loc();
    directive_ = tokens_.next().text;
}

void StatementReader::reject(std::string_view expected) {
    if (!ok_) return;
    ok_ = false;
    const FileLoc loc = tokens_.loc();
    log_.fatal(loc, "syntax", "expected {} for '{}', found {}", expected, directive_,
               describe(tokens_.peek()));
}

bool StatementReader::take(TokenKind kind, std::string_view expected) {
    if (!ok_) return false;
    if (tokens_.peek().kind != kind) {
        reject(expected);
        return false;
    }
    return true;
}

std::string StatementReader::string(std::string_view what) {
    if (ok_ && tokens_.peek().kind != TokenKind::string) reject(fmt::format("{} in quotes", what));
    return ok_ ? std::string(tokens_.next().text) : std::string();
}

std::optional<std::string> StatementReader::optional_string() {
    if (!ok_ || tokens_.peek().kind != TokenKind::string) return std::nullopt;
    return std::string(tokens_.next().text);
}

bool StatementReader::at_word(std::string_view word) {
    return ok_ && tokens_.peek().kind == TokenKind::word && tokens_.peek().text == word;
}

std::string StatementReader::word(std::string_view expected) {
    if (!take(TokenKind::word, expected)) return {};
    return std::string(tokens_.next().text);
}

double StatementReader::number() {
    if (!take(TokenKind::word, "a number")) return 0;
    const std::optional<LooseNumber> read = read_number(tokens_.peek().text);
    if (!read) {
        reject("a number");
        return 0;
    }
    if (!read->extra.empty()) {
        const FileLoc loc = tokens_.loc();
        warn_of_extra(*read, tokens_.peek().text, loc, log_);
    }
    tokens_.next();
    return read->value;
}

void StatementReader::numbers(std::span<double> values, bool wants_brackets) {
    if (!ok_) return;
    const bool has_brackets = tokens_.peek().kind == TokenKind::open;
    if (has_brackets != wants_brackets) {
        log_.warn(tokens_.loc(), "brackets", "pbrt-v3 stops here: it wants '{}' {} brackets",
                  directive_, wants_brackets ? "with" : "without");
    }
    if (has_brackets) {
        tokens_.next();
    } else if (!values.empty()) {
        values.front() = number();
        values = values.subspan(1);
    }
    if (ok_) values = values.subspan(tokens_.take_numbers(values));
    for (double& value : values) value = number();
    if (has_brackets && take(TokenKind::close, "']'")) tokens_.next();
}

ParameterList StatementReader::parameters() {
    ParameterList list;
    ParameterReader reader(tokens_, spectra_, log_, directive_);
    while (ok_ && tokens_.peek().kind == TokenKind::string) ok_ = reader.read(list);
    // A string that is malformed was meant to be a parameter.
    if (ok_ && tokens_.peek().kind == TokenKind::malformed) reject("a parameter");
    return list;
}

}  // namespace etalon::pbrt
