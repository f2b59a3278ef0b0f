#include "core/formats/pbrt/parse.h"

#include <algorithm>

#include "core/formats/diagnostic_log.h"
#include "core/formats/nearest_name.h"
#include "core/formats/pbrt/foreign_words.h"
#include "core/formats/pbrt/parser.h"

namespace etalon::pbrt {
namespace {

constexpr std::array directive_tables = {shape_directives, block_directives,  transform_directives,
                                         look_directives,  medium_directives, option_directives};

/// The directives by their first letter, as a scene may have millions of them.
class DirectivesByInitial {
  public:
    DirectivesByInitial() {
        for (const auto& table : directive_tables) {
            for (const Directive& directive : table()) of(directive.word).push_back(&directive);
        }
    }

    const Directive* find(std::string_view word) const {
        for (const Directive* directive : of(word)) {
            if (directive->word == word) return directive;
        }
        return nullptr;
    }

  private:
    using Directives = std::vector<const Directive*>;

    const Directives& of(std::string_view word) const {
        return all_[word.empty() ? 0 : static_cast<unsigned char>(word.front())];
    }
    Directives& of(std::string_view word) { return all_[static_cast<unsigned char>(word.front())]; }

    std::array<Directives, 256> all_;
};

std::vector<std::string_view> directive_words() {
    std::vector<std::string_view> words;
    for (const auto& table : directive_tables) {
        for (const Directive& directive : table()) words.push_back(directive.word);
    }
    return words;
}

/// Skips to the next directive.
void skip_statement(Parser& p) {
    while (p.tokens.peek().kind != TokenKind::end) {
        const Token& token = p.tokens.peek();
        if (token.kind == TokenKind::word && find_directive(token.text)) return;
        p.tokens.next();
    }
}

void reject(Parser& p, const Token& token) {
    const FileLoc loc = p.tokens.loc();
    const std::string_view origin =
        token.kind == TokenKind::word ? origin_of_directive(token.text) : std::string_view();
    if (!origin.empty()) {
        p.log.fatal(loc, "version", "{} is of {}; Etalon reads version 3", in_quotes(token.text),
                    origin);
    } else {
        p.log.fatal(loc, "syntax", "expected a directive, found {}{}", describe(token),
                    p.log.hint(Severity::error, "syntax",
                               [&] { return did_you_mean(token.text, directive_words()); }));
    }
}

bool is_allowed(const Directive& directive, Block block) {
    using enum Directive::Allowed;
    return directive.allowed == anywhere ||
           directive.allowed == (block == Block::options ? in_options : in_world);
}

void read_statement(Parser& p, const Directive& directive) {
    p.in.begin();
    if (is_allowed(directive, p.now.block)) {
        directive.run(p);
        if (!p.in.ok()) skip_statement(p);
        return;
    }
    if (directive.word == "WorldBegin") {
        p.log.error(p.in.where(), "block", "'WorldBegin' is left out: the world has begun already");
    } else {
        p.log.error(p.in.where(), "block", "'{}' is left out: it belongs {} WorldBegin",
                    directive.word, p.now.block == Block::options ? "after" : "before");
    }
    skip_statement(p);
}

void read_all(Parser& p) {
    while (p.tokens.peek().kind != TokenKind::end) {
        const Token& token = p.tokens.peek();
        const Directive* const directive =
            token.kind == TokenKind::word ? find_directive(token.text) : nullptr;
        if (directive) {
            read_statement(p, *directive);
        } else {
            reject(p, token);
            skip_statement(p);
        }
    }
}

/// Ends the frame of a file that ends before its world, as a truncated one does.
void end_file(Parser& p) {
    if (p.now.block == Block::world) {
        p.log.error(p.tokens.loc(), "end", "the file ends without WorldEnd");
        end_frame(p);
    } else if (p.frames.empty()) {
        p.log.error(p.tokens.loc(), "end", "the file has no WorldBegin: there is nothing to see");
    }
}

}  // namespace

bool is_directive(std::string_view word) {
    return find_directive(word) || !origin_of_directive(word).empty();
}

const Directive* find_directive(std::string_view word) {
    static const DirectivesByInitial directives;
    return directives.find(word);
}

ParsedFile parse(std::string_view text, const std::string& path, const ParseOptions& options) {
    Log log(options.strict);
    Parser parser(text, path, options.root, log);
    read_all(parser);
    end_file(parser);
    if (options.one_sided) {
        log.warn({}, "file",
                 "--one-sided is not for PBRT scenes: surfaces are seen from both sides");
    }
    return {std::move(parser.frames), log.take_files(), log.take(), log.is_fatal()};
}

}  // namespace etalon::pbrt
