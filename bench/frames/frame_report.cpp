#include "bench/frames/frame_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/common/progress_line.h"
#include "bench/frames/stages.h"

namespace etalon::frames {
namespace {

using table::Detail;

constexpr int name_width = 17;
constexpr int longest_scene = 90;

table::Columns<FrameFigures> columns() {
    table::Columns<FrameFigures> all;
    for (const Stage& stage : stages()) {
        all.push_back(
            {"", stage.heading, stage.width,
             [&stage](const FrameFigures& f) { return fmt::format("{:.3f}", stage.seconds(f)); },
             stage.meaning});
    }
    all.push_back({"over-", "head", 6,
                   [](const FrameFigures& f) { return fmt::format("{:.2f}", f.overhead()); },
                   "render / inters."});
    all.push_back({"", "ratio", 6,
                   [](const FrameFigures& f) { return fmt::format("{:.2f}", f.ratio); },
                   "render of embree-builtin, or of the first backend without it, / render"});
    all.push_back({"", "ns/ray", 8,
                   [](const FrameFigures& f) { return fmt::format("{:.1f}", f.nanoseconds()); },
                   "nanoseconds of render for each ray of the frame", Detail::wide});
    return all;
}

}  // namespace

std::string table_of(std::span<const FrameFigures> frames, Detail detail) {
    const table::Columns<FrameFigures> all = columns();
    std::string text = table::heading(fmt::format("{:{}}", "CPU seconds", name_width), all, detail);
    const FrameFigures* above = nullptr;
    for (const FrameFigures& f : frames) {
        if (above == nullptr || above->scene != f.scene) {
            text += shortened(f.scene, longest_scene) + "\n";
        }
        text += table::line_of(fmt::format("  {:{}}", f.backend, name_width - 2), f, all, detail);
        above = &f;
    }
    table::Legend legend;
    table::explain(all, detail, legend);
    return text + "\n" + legend.text();
}

nlohmann::ordered_json json_of(const FrameFigures& f) {
    nlohmann::ordered_json cpu;
    for (const Stage& stage : stages()) cpu[stage.key] = stage.seconds(f);
    return {{"scene", f.scene},     {"backend", f.backend}, {"width", f.width},
            {"height", f.height},   {"spp", f.samples},     {"rays", f.rays},
            {"repeats", f.repeats}, {"cpu_seconds", cpu},   {"overhead", f.overhead()},
            {"ratio", f.ratio}};
}

}  // namespace etalon::frames
