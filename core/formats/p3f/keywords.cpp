#include "core/formats/p3f/keywords.h"

#include <algorithm>
#include <array>

namespace etalon::p3f {
namespace {

struct Keyword {
    std::string_view name;
    Handler read;
};

// To add a statement: its reader in the fitting file of this folder, declared in loader.h, and a
// line here. The most frequent come first: the table is searched in order.
constexpr std::array keywords = {
    Keyword{"s", read_sphere},
    Keyword{"p", read_polygon},
    Keyword{"pp", read_patch},
    Keyword{"mat", read_mat},
    Keyword{"f", read_f},
    Keyword{"box", read_box},
    Keyword{"c", read_cone},
    Keyword{"mesh", read_mesh},
    Keyword{"pl", read_plane},
    Keyword{"npl", read_hessian_plane},
    Keyword{"light", read_light},
    Keyword{"l", read_point_light},
    Keyword{"camera", read_camera},
    Keyword{"v", read_camera},
    Keyword{"bclr", read_background},
    Keyword{"env", read_environment},
    Keyword{"accel", read_accel},
    Keyword{"spp", read_samples},
};

/// Keywords that single repositories of the course added for themselves.
constexpr std::array private_keywords = {
    Keyword{"sm", skip_private_extension},   Keyword{"ms", skip_private_extension},
    Keyword{"a", skip_private_extension},    Keyword{"al", skip_private_extension},
    Keyword{"fire", skip_private_extension},
};

constexpr auto names = [] {
    std::array<std::string_view, keywords.size()> result;
    for (std::size_t i = 0; i < keywords.size(); ++i) result[i] = keywords[i].name;
    return result;
}();

}  // namespace

Handler find_handler(std::string_view word) {
    const auto named = [&](const Keyword& k) { return k.name == word; };
    if (const auto k = std::ranges::find_if(keywords, named); k != keywords.end()) return k->read;
    const auto k = std::ranges::find_if(private_keywords, named);
    return k != private_keywords.end() ? k->read : nullptr;
}

std::span<const std::string_view> keyword_names() {
    return names;
}

std::size_t skip_to_keyword(Reader& in) {
    std::size_t words = 0;
    Tokenizer& tokens = in.tokens();
    for (; !tokens.at_end() && !find_handler(tokens.peek()); ++words) tokens.next();
    return words;
}

void skip_private_extension(Loader& loader) {
    loader.in.warn("extension", "'{}' is a private extension of one program; it is left out",
                   loader.in.keyword());
    skip_to_keyword(loader.in);
}

}  // namespace etalon::p3f
