#include <fmt/format.h>

#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

Figure figure_of(const ImageFigures& p, const std::string& date) {
    Images images;
    for (const auto& layer : p.layers) {
        images.images.push_back({layer.title, layer.png, p.width, p.height});
    }
    return {p.scene,
            fmt::format("{}, {} × {} pixels; rendered once, by all threads, in {} CPU seconds.",
                        count_of(p.primitives, "primitive"), p.width, p.height,
                        three_digits(p.render.cpu)),
            p.command, date, std::move(images)};
}

}  // namespace

Section images_section(const Results& results) {
    Section section{"images", "Images", {}, {}};
    section.prose = {
        "Rendered images. Every pixel has the same value with every exact backend and any number "
        "of threads. Beside each image: its difference from one with fewer samples (FLIP, "
        "Andersson et al. 2020; black is no difference), the number of rays of a sample, and the "
        "number of boxes and primitives against which a camera ray is tested."};
    for (const ImageFigures& p : results.images.list) {
        section.figures.push_back(figure_of(p, results.images.date));
    }
    return section;
}

}  // namespace etalon::bench_report
