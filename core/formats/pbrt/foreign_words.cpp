#include "core/formats/pbrt/foreign_words.h"

#include <algorithm>
#include <array>

namespace etalon::pbrt {
namespace {

constexpr std::string_view version_1 = "PBRT version 1";
constexpr std::string_view version_2 = "PBRT version 2";
constexpr std::string_view version_4 = "PBRT version 4";
constexpr std::string_view fork = "a fork of PBRT version 3";

struct ForeignDirective {
    std::string_view word, origin;
};

constexpr std::array directives = {
    ForeignDirective{"SurfaceIntegrator", version_2},
    ForeignDirective{"VolumeIntegrator", version_2},
    ForeignDirective{"Renderer", version_2},
    ForeignDirective{"Volume", version_2},
    ForeignDirective{"SearchPath", version_1},
    ForeignDirective{"ColorSpace", version_4},
    ForeignDirective{"Option", version_4},
    ForeignDirective{"Attribute", version_4},
    ForeignDirective{"Import", version_4},
};

struct ForeignPlugin {
    Category category;
    std::string_view name, origin;
};

constexpr std::array plugins = {
    ForeignPlugin{Category::integrator, "photonmap", version_2},
    ForeignPlugin{Category::integrator, "exphotonmap", version_2},
    ForeignPlugin{Category::integrator, "igi", version_2},
    ForeignPlugin{Category::integrator, "irradiancecache", version_2},
    ForeignPlugin{Category::integrator, "dipolesubsurface", version_2},
    ForeignPlugin{Category::integrator, "simplepath", version_4},
    ForeignPlugin{Category::integrator, "simplevolpath", version_4},
    ForeignPlugin{Category::integrator, "lightpath", version_4},
    ForeignPlugin{Category::integrator, "randomwalk", version_4},
    ForeignPlugin{Category::integrator, "function", version_4},
    ForeignPlugin{Category::integrator, "depthmap", fork},
    ForeignPlugin{Category::integrator, "pssps", fork},
    ForeignPlugin{Category::integrator, "cv", fork},
    ForeignPlugin{Category::integrator, "direct", fork},
    ForeignPlugin{Category::sampler, "adaptive", version_2},
    ForeignPlugin{Category::sampler, "bestcandidate", version_2},
    ForeignPlugin{Category::sampler, "independent", version_4},
    ForeignPlugin{Category::sampler, "zsobol", version_4},
    ForeignPlugin{Category::sampler, "paddedsobol", version_4},
    ForeignPlugin{Category::sampler, "pmj02bn", version_4},
    ForeignPlugin{Category::sampler, "neural", fork},
    ForeignPlugin{Category::film, "rgb", version_4},
    ForeignPlugin{Category::film, "gbuffer", version_4},
    ForeignPlugin{Category::film, "spectral", version_4},
    ForeignPlugin{Category::film, "cv", fork},
    ForeignPlugin{Category::camera, "spherical", version_4},
    ForeignPlugin{Category::accelerator, "grid", version_2},
    ForeignPlugin{Category::shape, "bilinearmesh", version_4},
    ForeignPlugin{Category::material, "shinymetal", version_2},
    ForeignPlugin{Category::material, "measured", "PBRT version 2 or 4"},
    ForeignPlugin{Category::material, "diffuse", version_4},
    ForeignPlugin{Category::material, "coateddiffuse", version_4},
    ForeignPlugin{Category::material, "conductor", version_4},
    ForeignPlugin{Category::material, "coatedconductor", version_4},
    ForeignPlugin{Category::material, "dielectric", version_4},
    ForeignPlugin{Category::material, "thindielectric", version_4},
    ForeignPlugin{Category::material, "diffusetransmission", version_4},
    ForeignPlugin{Category::material, "interface", version_4},
    ForeignPlugin{Category::material, "dual", fork},
    ForeignPlugin{Category::medium, "uniformgrid", version_4},
    ForeignPlugin{Category::medium, "rgbgrid", version_4},
    ForeignPlugin{Category::medium, "cloud", version_4},
    ForeignPlugin{Category::medium, "nanovdb", version_4},
};

}  // namespace

std::string_view origin_of_directive(std::string_view word) {
    const auto found = std::ranges::find(directives, word, &ForeignDirective::word);
    return found != directives.end() ? found->origin : std::string_view();
}

std::string_view origin_of_plugin(Category category, std::string_view name) {
    const auto found = std::ranges::find_if(
        plugins, [&](const ForeignPlugin& p) { return p.category == category && p.name == name; });
    return found != plugins.end() ? found->origin : std::string_view();
}

}  // namespace etalon::pbrt
