// The tables of docs/pbrt.md against those of the reader.
#include <fstream>
#include <sstream>

#include "core/formats/pbrt/plugin_type.h"
#include "tests/catch.h"

using namespace etalon::pbrt;

namespace {

std::string document() {
    std::ifstream in(ETALON_SOURCE_DIR "/docs/pbrt.md");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The text below the heading of a category, up to the next heading.
std::string section(const std::string& text, std::string_view heading) {
    const std::string line = "\n### " + std::string(heading) + "\n";
    const std::size_t begin = text.find(line);
    REQUIRE(begin != std::string::npos);
    return text.substr(begin, text.find("\n#", begin + line.size()) - begin);
}

}  // namespace

TEST_CASE("docs/pbrt.md states for each plugin what is rendered") {
    const std::string text = document();
    for (std::size_t c = 0; c < category_count; ++c) {
        const auto category = static_cast<Category>(c);
        const std::string rows = section(text, to_string(category));
        const auto types = plugin_types(category);
        for (const PluginType& type : types) {
            const std::string_view rendered = type.stand_in.empty() ? "itself" : type.stand_in;
            const std::string row =
                "\n| `" + std::string(type.name) + "` | " + std::string(rendered) + " |";
            INFO(row);
            CHECK(rows.find(row) != std::string::npos);
        }
        std::size_t count = 0;
        for (std::size_t at = 0; (at = rows.find("\n| `", at)) != std::string::npos; ++at) ++count;
        CHECK(count == types.size());
    }
}
