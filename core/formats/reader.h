#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "core/formats/diagnostic_log.h"
#include "core/formats/tokenizer.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Reads the values of a statement ("s 0 0 0 1") from a text, and reports those that are not as
/// expected. Like a stream it remembers a failure: from then on every value is zero and no word is
/// consumed, until recover(). So a loader can read all values and then check ok() once.
class Reader {
  public:
    /// Reads a whole text; `keywords` are the words that start statements.
    Reader(std::string_view text, DiagnosticLog& log, std::span<const std::string_view> keywords)
        : tokens_(text), log_(log), keywords_(keywords) {}

    /// Reads one line, for a format in which the line ends a statement.
    Reader(const Tokenizer& line, DiagnosticLog& log)
        : tokens_(line), log_(log), end_("the end of the line") {}

    /// Takes the next word as the keyword of a new statement.
    std::string_view begin();
    std::string_view keyword() const { return keyword_; }

    bool at_keyword() const;

    /// Skips everything up to the next keyword. Returns how many words that were.
    std::size_t skip_to_keyword();

    bool ok() const { return ok_; }
    void recover() { ok_ = true; }

    Tokenizer& tokens() { return tokens_; }
    const Tokenizer& tokens() const { return tokens_; }

    /// Returns the offset at which the statement starts.
    std::size_t start() const { return start_; }

    /// Reads finite values. `what` is for messages: "expected a number for the `what` of 's'".
    double number(std::string_view what) { return read<double>("a number", what); }
    std::int64_t integer(std::string_view what) {
        return read<std::int64_t>("a whole number", what);
    }
    Vec3 vector(std::string_view what);
    Color color(std::string_view what);
    std::string_view word(std::string_view what);

    /// Reads the number of items that follow, each of at least `numbers` numbers. Fails if the rest
    /// of the text is too short for them, so that no space is reserved for items that cannot
    /// follow.
    std::size_t count(std::string_view what, std::size_t numbers);

    /// Returns the largest number of items of `numbers` numbers that the rest of the text could
    /// hold.
    std::size_t room_for(std::size_t numbers) const;

    /// Warns about the place `offset`, or about the statement as a whole.
    template <class... T>
    void warn_at(std::size_t offset, std::string_view kind, fmt::format_string<T...> text,
                 T&&... arguments) {
        log_.warn(offset, kind, text, std::forward<T>(arguments)...);
    }
    template <class... T>
    void warn(std::string_view kind, fmt::format_string<T...> text, T&&... arguments) {
        log_.warn(start_, kind, text, std::forward<T>(arguments)...);
    }

    /// Reports an error in the statement that makes the scene unusable.
    template <class... T>
    void error(std::string_view kind, fmt::format_string<T...> text, T&&... arguments) {
        log_.error(start_, kind, text, std::forward<T>(arguments)...);
    }

    /// Reports an error and fails the statement.
    template <class... T>
    void fail_at(std::size_t offset, std::string_view kind, fmt::format_string<T...> text,
                 T&&... arguments) {
        log_.warn(offset, kind, text, std::forward<T>(arguments)...);
        ok_ = false;
    }

  private:
    template <class T>
    T read(std::string_view expected, std::string_view what) {
        T value = 0;
        if (!ok_) return 0;
        const NumberStatus status = tokens_.number(value);
        if (status == NumberStatus::ok) return value;
        reject(expected, what, status);
        return 0;
    }
    void reject(std::string_view expected, std::string_view what, NumberStatus status);

    Tokenizer tokens_;
    DiagnosticLog& log_;
    std::span<const std::string_view> keywords_{};
    std::string_view end_ = "the end of the file";  // in messages
    std::string_view keyword_;
    std::size_t start_ = 0;
    bool ok_ = true;
};

}  // namespace etalon
