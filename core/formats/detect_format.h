// Detection of a text's format from how it starts.
#pragma once

#include <string_view>
#include <vector>

namespace etalon {

/// A word and how many numbers follow it.
struct Statement {
    std::string_view word;
    int numbers;
};

/// The beginning of a text, as much as is needed to detect its format.
struct FormatProbe {
    explicit FormatProbe(std::string_view text);

    std::string_view text;
    std::vector<Statement> statements;
};

using FormatMatcher = bool (*)(const FormatProbe&);

bool is_p3f(const FormatProbe&);
bool is_nff(const FormatProbe&);
bool is_prt(const FormatProbe&);
bool is_sce(const FormatProbe&);
bool is_pbrt_v4(const FormatProbe&);
bool is_pbrt(const FormatProbe&);
bool is_obj(const FormatProbe&);
bool is_binary(const FormatProbe&);

}  // namespace etalon
