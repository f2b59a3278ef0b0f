// Compares the inventory in docs/pbrt.md with the reader's tables.
#include <fmt/format.h>

#include "tests/catch.h"
#include "tests/inventory/row.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
using pbrt::ParameterSpec;
using pbrt::PluginType;

namespace {

constexpr std::string_view heading = "## Inventory\n";

/// Returns a parameter with its default.
std::string described(const ParameterSpec& spec) {
    std::string text = fmt::format("`{}`", spec.name);
    for (std::size_t i = 0; i < spec.other_spellings().size(); ++i) {
        const std::string_view other = spec.other_spellings()[i].name;
        if (other != spec.name && text.find(other) == text.npos)
            text += fmt::format(" or `{}`", other);
    }
    if (!spec.default_value.same_as.empty()) {
        const std::string_view sign = spec.default_value.factor < 0 ? "-" : "";
        return text + fmt::format(" {}{}", sign, spec.default_value.same_as);
    }
    std::string value = default_of(spec);
    while (value.ends_with(' ')) value.pop_back();
    return value.empty() ? text : text + " " + value;
}

std::string row_of(const PluginType& type) {
    std::string parameters, without_effect;
    for (const ParameterSpec& spec : type.parameters) {
        parameters += (parameters.empty() ? "" : ", ") + described(spec);
        const Row* row = find_row(type, spec.name);
        if (!row || row->no_effect.empty()) continue;
        without_effect += (without_effect.empty() ? "" : "; ") +
                          fmt::format("`{}`: {}", spec.name, row->no_effect);
    }
    const std::string alias = type.alias.empty() ? "" : fmt::format(" or `{}`", type.alias);
    return fmt::format("| {} | `{}`{} | {} | {} | {} |\n", to_string(type.category), type.name,
                       alias, type.stand_in.empty() ? "itself" : type.stand_in, parameters,
                       without_effect);
}

std::string inventory() {
    std::string text(heading);
    text +=
        "\nEvery plugin and every parameter that pbrt-v3 reads, with its default there. \"Itself\" "
        "means that\nthe plugin is rendered. A test renders a scene for each parameter, which must "
        "change with it but\nwhere the last column says why it does not.\n\n"
        "| category | plugin | how Etalon renders it | parameters and defaults | parameters "
        "without effect |\n"
        "|---|---|---|---|---|\n";
    for (std::size_t c = 0; c < pbrt::category_count; ++c) {
        for (const PluginType& type : plugin_types(static_cast<pbrt::Category>(c))) {
            text += row_of(type);
        }
    }
    return text;
}

}  // namespace

TEST_CASE("docs/pbrt.md ends with the inventory of the tables") {
    const std::string document = content_of(ETALON_SOURCE_DIR "/docs/pbrt.md");
    const std::string expected = inventory();
    const std::size_t begin = document.find(heading);
    const bool is_same = begin != document.npos && document.substr(begin) == expected;
    const std::string update = ETALON_BINARY_DIR "/pbrt_inventory.md";
    if (!is_same) put(update, expected);
    INFO("the end of docs/pbrt.md, from '## Inventory' on, must be that of " + update);
    CHECK(is_same);
}
