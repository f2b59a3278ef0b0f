// Telling what a text is from how it starts.
#pragma once

#include <string_view>
#include <vector>

namespace etalon {

/// A word and how many numbers follow it.
struct Statement {
    std::string_view word;
    int numbers;
};

/// The start of a text, as far as is worth reading to tell what it is.
struct Opening {
    explicit Opening(std::string_view text);

    std::string_view text;
    std::vector<Statement> statements;
};

using Recogniser = bool (*)(const Opening&);

bool is_p3f(const Opening&);
bool is_nff(const Opening&);
bool is_prt(const Opening&);
bool is_sce(const Opening&);
bool is_pbrt_v4(const Opening&);
bool is_pbrt(const Opening&);
bool is_obj(const Opening&);
bool is_binary(const Opening&);

}  // namespace etalon
