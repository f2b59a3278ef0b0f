#include <fmt/format.h>

#include "bench/report/sections/sections.h"
#include "bench/report/words.h"

namespace etalon::bench_report {
namespace {

Figure figure_of(const PictureFigures& p, const std::string& date) {
    Images images;
    for (const auto& layer : p.layers) {
        images.images.push_back({layer.title, layer.png, p.width, p.height});
    }
    return {p.scene,
            fmt::format("{}, {} × {} pixels with {} each, {} CPU seconds.",
                        count_of(p.primitives, "primitive"), p.width, p.height,
                        count_of(static_cast<std::uint64_t>(p.samples), "sample"),
                        three_digits(p.render.cpu)),
            p.command, date, std::move(images)};
}

}  // namespace

Section pictures_section(const Results& results) {
    Section section{"pictures", "Pictures", {}, {}};
    section.prose = {
        "What the rays are for. Small here; every pixel is the same by every exact "
        "backend and any number of threads."};
    for (const PictureFigures& p : results.pictures.list) {
        section.figures.push_back(figure_of(p, results.pictures.date));
    }
    return section;
}

}  // namespace etalon::bench_report
