#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/formats/file_scope.h"
#include "core/formats/locator.h"
#include "core/formats/mapped_file.h"
#include "core/formats/pbrt/lexer.h"
#include "core/formats/pbrt/log.h"

namespace etalon::pbrt {

/// The tokens of a file and of the files that it includes, in their place. The end of an included
/// file separates tokens like a blank.
class TokenStream {
  public:
    /// The text and the log must outlive the stream. `path` names the text, and its directory is
    /// the one in which files are searched; none outside of `root` may be opened, unless `root` is
    /// empty.
    TokenStream(std::string_view text, const std::string& path, const std::string& root, Log& log);

    /// Returns the next token; its text is valid until the stream moves past it.
    const Token& peek() {
        if (!has_token_) read();
        return token_;
    }
    Token next() {
        peek();
        has_token_ = false;
        return token_;
    }

    /// Returns the location of the next token.
    FileLoc loc();

    /// Appends the plain numbers that follow. No token may have been peeked at.
    template <class T>
    void take_numbers(std::vector<T>& values) {
        sources_.back().lexer.take_numbers(values);
    }

    /// Fills `values` with the plain numbers that follow. Returns how many there were. No token may
    /// have been peeked at.
    std::size_t take_numbers(std::span<double> values) {
        return sources_.back().lexer.take_numbers(values);
    }

    /// Continues with another file, up to its end. Reports an error if that is impossible.
    void include(const std::string& name, FileLoc where);

    /// Returns the path of a file that the scene names; nothing, and an error, if it may not be
    /// opened.
    std::optional<std::string> resolve(const std::string& name, FileLoc where) const;

  private:
    /// Reads the next token, of this source or of those around it.
    void read();

    struct Source {
        std::string path;
        std::uint32_t file;
        std::unique_ptr<MappedFile> text;  ///< null for the text that the stream was made with
        Lexer lexer;
        Locator locator;
    };

    /// Returns why the file must not be read; empty if it may.
    std::string check_readable(const std::string& path) const;
    std::uint32_t number_of(const std::string& path);
    void enter(const std::string& path, std::unique_ptr<MappedFile> file, std::string_view text);

    Log& log_;
    std::filesystem::path directory_;
    FileScope scope_;
    std::vector<Source> sources_;  ///< the file being read is the last
    std::unordered_map<std::string, std::uint32_t> files_;
    std::size_t included_files_ = 0, repeated_bytes_ = 0;
    Token token_{};
    bool has_token_ = false;
};

}  // namespace etalon::pbrt
