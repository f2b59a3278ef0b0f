// Every parameter of every PBRT plugin changes the image, unless its row says why not.
#include <fmt/format.h>

#include "tests/catch.h"
#include "tests/inventory/row.h"
#include "tests/inventory/worlds.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
using pbrt::Category;
using pbrt::ParameterSpec;
using pbrt::PluginType;
using pbrt::ValueType;

namespace {

bool is_quoted(ValueType type) {
    return type == ValueType::string || type == ValueType::file || type == ValueType::material ||
           type == ValueType::flag;
}

std::string given(std::string_view name, ValueType type, std::string_view value) {
    if (value.starts_with('@')) {
        return fmt::format(" \"texture {}\" \"{}\"", name, value.substr(1));
    }
    const std::string_view quote = is_quoted(type) ? "\"" : "";
    return fmt::format(" \"{} {}\" [ {}{}{} ]", to_string(type), name, quote, value, quote);
}

using Pixels = std::vector<Color>;

/// Renders scenes in a folder with the files that they name.
class SceneRenderer {
  public:
    SceneRenderer() { write_files(folder_ / ""); }

    Pixels render(const PluginType& plugin, const std::string& parameters,
                  const std::string& textures = {}) const {
        const std::string text = world_with(plugin, parameters, textures);
        LoadResult loaded = load_scene_text(text, folder_ / "scene.pbrt");
        INFO(text);
        INFO(report(loaded.diagnostics));
        REQUIRE(loaded.scene);
        std::vector<std::string> problems;
        make_cut_outs(*loaded.scene, problems);
        REQUIRE(problems.empty());
        TestScene scene;
        static_cast<Scene&>(scene) = std::move(*loaded.scene);
        scene.settings = loaded.settings;
        return rendered(scene).film.pixels();
    }

  private:
    TemporaryFolder folder_;
};

bool is_same(const Pixels& a, const Pixels& b) {
    return a == b;
}

/// A row with its parameter.
struct Change {
    const SceneRenderer& renderer;
    const PluginType& plugin;
    const ParameterSpec& spec;
    const Row& row;

    Pixels with(std::string_view name, ValueType type, std::string_view value) const {
        return renderer.render(plugin, std::string(row.with) + given(name, type, value));
    }
    /// Returns whether the first image has a value of its own.
    bool is_given_before() const {
        const bool is_among_others =
            row.with.find(fmt::format(" {}\"", spec.name)) != std::string_view::npos;
        return is_among_others || !row.other.empty();
    }
    Pixels before() const {
        return row.other.empty() ? renderer.render(plugin, std::string(row.with))
                                 : with(spec.name, spec.type, row.other);
    }
    Pixels after() const { return with(spec.name, spec.type, row.value); }

    /// With a texture in place of the value.
    Pixels textured(const std::string& texture) const {
        const bool is_number = spec.type == ValueType::number;
        return renderer.render(
            plugin, std::string(row.with) + given(spec.name, spec.type, "@made"),
            fmt::format("Texture \"made\" \"{}\" {}\n", is_number ? "float" : "spectrum", texture));
    }
};

/// Checks that a texture has an effect, and that one that is not constant has another.
void check_textures(const Change& c, const Pixels& before, const Pixels& after) {
    const Pixels even = c.textured("\"constant\"" + given("value", c.spec.type, c.row.value));
    CHECK_FALSE(is_same(even, before));
    const bool is_number = c.spec.type == ValueType::number;
    const Pixels uneven = c.textured("\"checkerboard\" \"float uscale\" 7 \"float vscale\" 5" +
                                     given("tex1", c.spec.type, c.row.value) +
                                     given("tex2", c.spec.type, is_number ? "1" : "0.6 0.7 1"));
    CHECK_FALSE(is_same(uneven, before));
    CHECK_FALSE(is_same(uneven, after));
}

void check(const Change& c) {
    const Pixels before = c.before(), after = c.after();
    if (!c.row.no_effect.empty()) {
        CHECK(is_same(before, after));
        return;
    }
    // Of plugins that are replaced by others, only integrators have parameters with an effect.
    if (!c.plugin.stand_in.empty() && c.plugin.category != Category::integrator) return;
    CHECK_FALSE(is_same(before, after));
    const std::string preset = default_of(c.spec);
    if (!c.is_given_before() && !preset.empty()) {
        CHECK(is_same(c.with(c.spec.name, c.spec.type, preset), before));
    }
    for (const pbrt::Spelling& other : c.spec.other_spellings()) {
        CAPTURE(other.name);
        CHECK(is_same(c.with(other.name, other.type, c.row.value), after));
    }
    if (c.spec.slot == pbrt::Slot::texture && !c.row.value.starts_with('@')) {
        check_textures(c, before, after);
    }
}

}  // namespace

TEST_CASE("every parameter of every plugin changes the image, or it is said why not") {
    const SceneRenderer renderer;
    for (std::size_t c = 0; c < pbrt::category_count; ++c) {
        for (const PluginType& plugin : plugin_types(static_cast<Category>(c))) {
            for (const ParameterSpec& spec : plugin.parameters) {
                CAPTURE(to_string(plugin.category), plugin.name, spec.name);
                const Row* row = find_row(plugin, spec.name);
                CHECK(row != nullptr);
                if (row) check({renderer, plugin, spec, *row});
            }
        }
    }
}
