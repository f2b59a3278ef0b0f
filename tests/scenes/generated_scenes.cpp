#include "tests/scenes/generated_scenes.h"

#include <fmt/format.h>

#include "core/formats/load.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

namespace etalon::test {

std::string family_text(const std::string& family, std::int64_t size) {
    const Folder folder;
    const auto result = folder.shell(
        fmt::format("exec {}/bin/etalon-scenes {} --size {}", ETALON_BINARY_DIR, family, size));
    REQUIRE(result.err == "");
    REQUIRE(result.status == 0);
    return result.out;
}

Scene family_scene(const std::string& family, std::int64_t size) {
    LoadOptions options;
    options.strict = true;
    auto result = load_scene_text(family_text(family, size), family + ".p3f", options);
    REQUIRE(report(result.diagnostics) == "");
    REQUIRE(result.scene.has_value());
    return std::move(*result.scene);
}

}  // namespace etalon::test
