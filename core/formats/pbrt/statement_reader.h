#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "core/formats/pbrt/parameter_list.h"
#include "core/formats/pbrt/spectrum_files.h"
#include "core/formats/pbrt/token_stream.h"

namespace etalon::pbrt {

/// Reads the arguments of one statement after another. Where pbrt-v3 would stop there is an error:
/// from then on nothing of the statement is read, and everything returned is empty.
class StatementReader {
  public:
    StatementReader(TokenStream& tokens, Log& log)
        : tokens_(tokens), log_(log), spectra_(tokens, log) {}

    /// Takes the directive, which is the next token.
    void begin();

    std::string_view directive() const { return directive_; }
    FileLoc where() const { return where_; }
    bool ok() const { return ok_; }

    /// Reads a quoted string; `what` names it in messages.
    std::string string(std::string_view what);

    /// Reads the next quoted string if there is one.
    std::optional<std::string> optional_string();

    /// Returns whether the next token is this word, without quotes.
    bool at_word(std::string_view word);

    /// Reads a word without quotes.
    std::string word(std::string_view expected);

    /// Fills `values` with numbers. pbrt-v3 requires brackets around some and none around others;
    /// both are read, with a warning if pbrt-v3 refuses them.
    void numbers(std::span<double> values, bool wants_brackets);

    ParameterList parameters();

    /// Reports an error at the next token, at which pbrt-v3 stops.
    void reject(std::string_view expected);

  private:
    bool take(TokenKind kind, std::string_view expected);
    double number();

    TokenStream& tokens_;
    Log& log_;
    SpectrumFiles spectra_;
    std::string directive_;
    FileLoc where_;
    bool ok_ = true;
};

}  // namespace etalon::pbrt
