#include "core/formats/detect_format.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "core/formats/pbrt/parse.h"
#include "core/formats/tokenizer.h"

namespace etalon {
namespace {

constexpr std::size_t bytes_read = std::size_t{1} << 16;
constexpr std::size_t statements_read = 1000;

/// Word that starts a statement; `numbers` is how many must follow it, or -1 for any number.
struct Signature {
    std::string_view word;
    int numbers = -1;
};

/// Keywords after which a name or a path follows, which may be the keyword of another format.
constexpr std::array<std::string_view, 5> before_names = {"instance", "instance_of", "env",
                                                          "object_flat", "object_phong"};

bool shows(const FormatProbe& probe, std::initializer_list<Signature> signatures) {
    return std::ranges::any_of(probe.statements, [&](const Statement& s) {
        return std::ranges::any_of(signatures, [&](const Signature& signature) {
            return s.word == signature.word &&
                   (signature.numbers < 0 || s.numbers == signature.numbers);
        });
    });
}

bool shows_in_turn(const FormatProbe& probe, std::string_view first, std::string_view second) {
    const auto& list = probe.statements;
    return std::adjacent_find(list.begin(), list.end(),
                              [&](const Statement& a, const Statement& b) {
                                  return a.word == first && b.word == second;
                              }) != list.end();
}

bool is_pbrt_of_any_version(const FormatProbe& probe) {
    return std::ranges::any_of(probe.statements, pbrt::is_directive, &Statement::word);
}

/// Matches words that have no meaning in version 3. `"spectrum"` textures and `"point3"` parameters
/// are more frequent in version 4, but legal in version 3.
bool shows_version_4(const FormatProbe& probe) {
    return shows(probe, {{"ColorSpace"}, {"Option"}, {"Attribute"}}) ||
           shows_in_turn(probe, "Film", "\"rgb\"") || shows_in_turn(probe, "Sampler", "\"zsobol\"");
}

}  // namespace

FormatProbe::FormatProbe(std::string_view whole) : text(whole.substr(0, bytes_read)) {
    Tokenizer tokens(text);
    while (!tokens.at_end() && statements.size() < statements_read) {
        if (!tokens.at_number() || statements.empty()) {
            statements.push_back({tokens.next_with_string(), 0});
            const bool is_named = std::ranges::count(before_names, statements.back().word) > 0;
            if (is_named) tokens.next_with_string();
        } else {
            tokens.next();
            ++statements.back().numbers;
        }
    }
}

bool is_p3f(const FormatProbe& probe) {
    return shows(probe, {{"bclr"},
                         {"mat", 11},
                         {"f", 11},
                         {"punctual"},
                         {"accel"},
                         {"spp"},
                         {"camera", 0},
                         {"aperture", 1},
                         {"focal", 1},
                         {"npl", 4},
                         {"env", 0}});
}

/// Matches what NFF shares with its descendant P3F, in texts that show nothing of P3F alone.
bool is_nff(const FormatProbe& probe) {
    return shows(probe, {{"b", 3}, {"f", 8}, {"l", 3}}) && !is_p3f(probe);
}

bool is_prt(const FormatProbe& probe) {
    return shows(probe, {{"surface", 19},
                         {"background"},
                         {"light", 3},
                         {"polygon", 1},
                         {"instance"},
                         {"quadric", 3},
                         {"hsphere"}});
}

bool is_sce(const FormatProbe& probe) {
    return shows(probe, {{"sce1.0"},
                         {"eyepos", 3},
                         {"eyedir", 3},
                         {"fovy_deg", 1},
                         {"nx", 1},
                         {"ny", 1},
                         {"max_recursion", 1},
                         {"aasample", 1},
                         {"ca", 3},
                         {"cr", 3},
                         {"cp", 3},
                         {"ball", 4},
                         {"cylinder", 0},
                         {"triangle", 9},
                         {"object_flat", 0},
                         {"object_phong", 0},
                         {"pointlight", 6},
                         {"arealight", 4}});
}

bool is_pbrt_v4(const FormatProbe& probe) {
    return is_pbrt_of_any_version(probe) && shows_version_4(probe);
}

bool is_pbrt(const FormatProbe& probe) {
    return is_pbrt_of_any_version(probe) && !shows_version_4(probe);
}

bool is_obj(const FormatProbe& probe) {
    return shows(probe, {{"v", 3}, {"v", 4}, {"v", 6}, {"vn", 3}, {"vt", 2}, {"mtllib"}});
}

/// Returns whether more than one byte in fifty does not occur in text.
bool is_binary(const FormatProbe& probe) {
    const auto strange = std::ranges::count_if(probe.text, [](char c) {
        return (c >= '\0' && c < '\t') || (c > '\r' && c < ' ') || c == '\x7F';
    });
    return static_cast<std::size_t>(strange) * 50 > probe.text.size();
}

}  // namespace etalon
