// Cameras, samplers, films, filters, integrators and accelerators.
#include <array>

#include "tests/inventory/row.h"

namespace etalon::test {
namespace {

constexpr std::string_view lens = "\"string lensfile\" \"lens.dat\" \"float focusdistance\" 4 ";
constexpr std::string_view full =
    "\"string lensfile\" \"lens.dat\" \"bool simpleweighting\" \"false\" ";

constexpr std::string_view has_no_lens = "all rays of an environment camera start at one point";

constexpr std::array cameras = {
    Row{"realistic", "shutteropen", "0.5", full},
    Row{"realistic", "shutterclose", "0.5", full},
    Row{"*", "shutteropen", "0.5"},
    Row{"*", "shutterclose", "0.5"},
    Row{"*", "lensradius", "0.3", "\"float focaldistance\" 4"},
    Row{"*", "focaldistance", "2", "\"float lensradius\" 0.3"},
    Row{"*", "frameaspectratio", "2.5"},
    Row{"*", "screenwindow", "-1 0.5 -1 1"},
    Row{"perspective", "fov", "40"},
    Row{"perspective", "halffov", "20"},
    Row{"environment", "lensradius", "0.3", {}, {}, has_no_lens},
    Row{"environment", "focaldistance", "2", {}, {}, has_no_lens},
    Row{"environment", "frameaspectratio", "2.5", {}, {}, "the image shows all directions"},
    Row{"environment", "screenwindow", "-1 0.5 -1 1", {}, {}, "the image shows all directions"},
    Row{"realistic", "lensfile", "other.dat", {}, "lens.dat"},
    Row{"realistic", "aperturediameter", "8", lens},
    Row{"realistic", "focusdistance", "2", full},
    Row{"realistic", "simpleweighting", "false", lens},
};

constexpr std::string_view own_points = "Etalon's sampler has any number of dimensions";

constexpr std::array samplers = {
    Row{"*", "pixelsamples", "7"},
    Row{"*", "dimensions", "2", {}, {}, own_points},
    Row{"halton", "samplepixelcenter", "true", {}, {}, "samples are spread over their pixel"},
    Row{"stratified", "xsamples", "2"},
    Row{"stratified", "ysamples", "2"},
    Row{"stratified", "jitter", "false", {}, {}, "samples are spread over their pixel"},
};

constexpr std::array films = {
    Row{"image", "xresolution", "18", "\"integer yresolution\" 18", "24"},
    Row{"image", "yresolution", "12", "\"integer xresolution\" 24", "18"},
    Row{"image", "cropwindow", "0.25 0.75 0 1",
        "\"integer xresolution\" 24 \"integer yresolution\" 18"},
    Row{"image", "scale", "2", "\"integer xresolution\" 24 \"integer yresolution\" 18"},
    Row{"image", "diagonal", "50", "\"integer xresolution\" 24 \"integer yresolution\" 18"},
    Row{"image", "maxsampleluminance", "0.05",
        "\"integer xresolution\" 24 \"integer yresolution\" 18"},
    Row{"image",
        "filename",
        "x.png",
        "\"integer xresolution\" 24 \"integer yresolution\" 18",
        {},
        "the command line names the output"},
};

constexpr std::array filters = {
    Row{"*", "xwidth", "1.3"},   Row{"*", "ywidth", "1.3"},   Row{"gaussian", "alpha", "0.5"},
    Row{"mitchell", "B", "0.9"}, Row{"mitchell", "C", "0.9"}, Row{"sinc", "tau", "1.5"},
};

constexpr std::string_view own_choice = "Etalon has its own light sampling strategy";
constexpr std::string_view a_path = "unidirectional path tracing is used instead";

constexpr std::array integrators = {
    Row{"*", "maxdepth", "1"},
    Row{"*", "pixelbounds", "3 17 2 11"},
    Row{"*", "rrthreshold", "0.1", "\"integer maxdepth\" 20"},
    Row{"*", "lightsamplestrategy", "uniform", {}, {}, own_choice},
    Row{"directlighting", "strategy", "one"},
    Row{"bdpt", "visualizestrategies", "true", {}, {}, a_path},
    Row{"bdpt", "visualizeweights", "true", {}, {}, a_path},
    Row{"mlt", "bootstrapsamples", "1000", {}, {}, a_path},
    Row{"mlt", "chains", "10", {}, {}, a_path},
    Row{"mlt", "mutationsperpixel", "10", {}, {}, a_path},
    Row{"mlt", "largestepprobability", "0.5", {}, {}, a_path},
    Row{"mlt", "sigma", "0.1", {}, {}, a_path},
    Row{"sppm", "iterations", "10", {}, {}, a_path},
    Row{"sppm", "photonsperiteration", "1000", {}, {}, a_path},
    Row{"sppm", "imagewritefrequency", "10", {}, {}, a_path},
    Row{"sppm", "radius", "0.1", {}, {}, a_path},
    Row{"ambientocclusion", "cossample", "false", {}, {}, "directions are always cosine-weighted"},
    Row{"ambientocclusion", "nsamples", "8", {}, {}, "each camera ray has one occlusion ray"},
};

constexpr std::string_view own_tree = "the command line names the backend";

constexpr std::array accelerators = {
    Row{"bvh", "splitmethod", "middle", {}, {}, own_tree},
    Row{"bvh", "maxnodeprims", "1", {}, {}, own_tree},
    Row{"kdtree", "intersectcost", "10", {}, {}, own_tree},
    Row{"kdtree", "traversalcost", "10", {}, {}, own_tree},
    Row{"kdtree", "emptybonus", "0.1", {}, {}, own_tree},
    Row{"kdtree", "maxprims", "4", {}, {}, own_tree},
    Row{"kdtree", "maxdepth", "4", {}, {}, own_tree},
};

}  // namespace

std::span<const Row> camera_rows() {
    return cameras;
}
std::span<const Row> sampler_rows() {
    return samplers;
}
std::span<const Row> film_rows() {
    return films;
}
std::span<const Row> filter_rows() {
    return filters;
}
std::span<const Row> integrator_rows() {
    return integrators;
}
std::span<const Row> accelerator_rows() {
    return accelerators;
}

}  // namespace etalon::test
