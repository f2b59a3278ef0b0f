#include "core/formats/pbrt/token_stream.h"

#include <algorithm>

#include "core/formats/diagnostic_log.h"

namespace etalon::pbrt {
namespace {

// Limits, as files can include each other so often that reading would never end.
constexpr std::size_t deepest = 100;
constexpr std::size_t most_files = 100'000;
constexpr std::size_t most_repeated_bytes = std::size_t{1} << 28;

/// Returns a path without `..` where that leads to the same place, or only that leads to any. It
/// does not after a folder that is a symbolic link. A folder that is left at once may be missing:
/// in a copy of the scene's files alone.
std::filesystem::path without_detours(const std::filesystem::path& path) {
    std::filesystem::path normal = path.lexically_normal();
    std::error_code none;
    if (!std::filesystem::exists(path, none) && std::filesystem::exists(normal, none)) {
        return normal;
    }
    const bool is_same = normal == path || std::filesystem::weakly_canonical(path, none) ==
                                               std::filesystem::weakly_canonical(normal, none);
    return is_same ? normal : path;
}

}  // namespace

TokenStream::TokenStream(std::string_view text, const std::string& path, const std::string& root,
                         Log& log)
    : log_(log), directory_(std::filesystem::path(path).parent_path()), scope_(root) {
    enter(path, nullptr, text);
}

void TokenStream::enter(const std::string& path, std::unique_ptr<MappedFile> file,
                        std::string_view text) {
    sources_.push_back({path, number_of(path), std::move(file), Lexer(text), Locator(text)});
}

std::uint32_t TokenStream::number_of(const std::string& path) {
    const auto [entry, is_new] = files_.try_emplace(path, 0);
    if (is_new) entry->second = log_.add_file(path);
    return entry->second;
}

void TokenStream::read() {
    token_ = sources_.back().lexer.next();
    while (token_.kind == TokenKind::end && sources_.size() > 1) {
        sources_.pop_back();
        token_ = sources_.back().lexer.next();
    }
    has_token_ = true;
}

FileLoc TokenStream::loc() {
    const std::size_t offset = peek().offset;
    Source& source = sources_.back();
    const TextPosition position = source.locator.locate(offset);
    return {source.file, position.line, position.column};
}

std::optional<std::string> TokenStream::resolve(const std::string& name, FileLoc where) const {
    if (name.empty()) return name;
    std::string path = without_detours(directory_ / name).string();
    const std::string error = scope_.check(path);
    if (error.empty()) return path;
    log_.fatal(where, "root", "{}", error);
    return std::nullopt;
}

std::string TokenStream::check_readable(const std::string& path) const {
    if (std::ranges::find(sources_, path, &Source::path) != sources_.end()) {
        return "it would include itself without end";
    }
    if (sources_.size() > deepest) {
        return fmt::format("files include each other {} deep, and no deeper", deepest);
    }
    if (included_files_ > most_files) {
        return fmt::format("{} files were included, and no more are", most_files);
    }
    return repeated_bytes_ <= most_repeated_bytes
               ? std::string()
               : "the files included again and again are too large together";
}

void TokenStream::include(const std::string& name, FileLoc where) {
    const std::optional<std::string> resolved = resolve(name, where);
    if (!resolved) return;
    const std::string& path = *resolved;
    ++included_files_;
    if (const std::string why = check_readable(path); !why.empty()) {
        log_.error(where, "include", "{} is not included: {}", path_in_quotes(path), why);
        return;
    }
    auto file = std::make_unique<MappedFile>(path, FileKind::regular);
    if (!file->error().empty()) {
        log_.error(where, "include", "{} {}; it is left out", path_in_quotes(path), file->error());
        return;
    }
    const std::string_view text = file->text();
    if (files_.contains(path)) repeated_bytes_ += text.size();
    enter(path, std::move(file), text);
}

}  // namespace etalon::pbrt
