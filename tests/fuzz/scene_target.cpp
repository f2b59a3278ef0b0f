#include "tests/fuzz/scene_target.h"

#include <filesystem>

#include "core/base/hash64.h"
#include "core/formats/load.h"
#include "core/formats/write/write.h"
#include "tests/formats/sane_scene.h"
#include "tests/fuzz/target.h"

namespace etalon::fuzz {
namespace {

constexpr std::size_t most_diagnostics = 200;

void check(const LoadResult& result) {
    require(result.diagnostics.size() <= most_diagnostics, "too many diagnostics");
    for (const Diagnostic& d : result.diagnostics) {
        require(!d.message.empty(), "a diagnostic without a message");
    }
    require(result.scene || !result.diagnostics.empty(), "neither a scene nor an error");
    if (result.scene && !result.scene->is_physical()) {
        const std::string defect = insanity(result);
        require(defect.empty(), "not sane: " + defect);
    }
}

bool becomes_facets(const Primitive& p) {
    return p.kind == kind_of<Ellipsoid>() || p.kind == kind_of<ClosedCylinder>() ||
           p.kind == kind_of<Ring>();
}

/// Returns whether the scene read from a text is also written: one scene in four, and one in 256 of
/// those with curved surfaces. In P3F each of these becomes a thousand facets, which take a
/// thousand times as long to write and read as the original text.
bool is_written(std::string_view text, const Scene& scene) {
    bool is_long = false;
    for (const Primitive p : scene.geometry.primitives) is_long = is_long || becomes_facets(p);
    return hash64(text) % (is_long ? 256 : 4) == 0;
}

/// Checks that a scene can be written, and that the written P3F can be read again.
void write(const LoadResult& result) {
    if (result.scene->is_physical()) return;
    write_pbrt(*result.scene, result.settings, "");
    const std::string text = write_p3f(*result.scene, result.settings, "").text;
    LoadOptions options;
    options.format = "p3f";
    const LoadResult again = load_scene_text(text, "again.p3f", options);
    const std::string why = again.diagnostics.empty() ? "" : again.diagnostics.front().message;
    require(again.scene.has_value(), "what was written cannot be read: " + why);
    check(again);
}

}  // namespace

void read_scene(const std::string& format, std::string_view text) {
    if (text.find('/') != text.npos) return;
    static const std::string path = (std::filesystem::current_path() / "scene").string();
    LoadOptions options;
    options.format = format;
    const LoadResult result = load_scene_text(text, path, options);
    check(result);
    if (result.scene && is_written(text, *result.scene)) write(result);
}

}  // namespace etalon::fuzz
