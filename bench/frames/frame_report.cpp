#include "bench/frames/frame_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/common/progress_line.h"
#include "bench/frames/stages.h"

namespace etalon::frames {
namespace {

using table::Detail;

constexpr int name_width = 20;

table::Columns<FrameFigures> columns() {
    table::Columns<FrameFigures> all = {
        {"", "backend", 24, [](const FrameFigures& f) { return f.backend; }, "", Detail::wide},
    };
    for (const Stage& stage : stages()) {
        all.push_back(
            {"", stage.heading, stage.width,
             [&stage](const FrameFigures& f) { return fmt::format("{:.3f}", stage.seconds(f)); },
             stage.meaning});
    }
    all.push_back({"", "overhead", 9,
                   [](const FrameFigures& f) { return fmt::format("{:.2f}", f.overhead()); },
                   "render / inters."});
    all.push_back({"", "ns/ray", 8,
                   [](const FrameFigures& f) { return fmt::format("{:.1f}", f.nanoseconds()); },
                   "nanoseconds of render for each ray of the frame", Detail::wide});
    return all;
}

std::string beginning(const std::string& text) {
    return fmt::format("{:{}}", shortened(text, name_width - 1), name_width);
}

}  // namespace

std::string table_of(std::span<const FrameFigures> frames, Detail detail) {
    const table::Columns<FrameFigures> all = columns();
    std::string text = table::heading(beginning("CPU seconds"), all, detail);
    for (const FrameFigures& f : frames) {
        text += table::line_of(beginning(f.scene), f, all, detail);
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
            {"repeats", f.repeats}, {"cpu_seconds", cpu},   {"overhead", f.overhead()}};
}

}  // namespace etalon::frames
