#include "bench/frames/frame_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace etalon::frames {
namespace {

/// A column of the table, and a key of the JSON.
struct Column {
    const char *heading, *key;
    double (*value)(const FrameFigures&);
};

constexpr Column seconds[] = {
    {"load", "load", [](const FrameFigures& f) { return f.load; }},
    {"build", "build", [](const FrameFigures& f) { return f.build; }},
    {"images", "images", [](const FrameFigures& f) { return f.images; }},
    {"camera", "camera", [](const FrameFigures& f) { return f.camera; }},
    {"inters.", "intersection", [](const FrameFigures& f) { return f.intersection; }},
    {"shading", "shading", [](const FrameFigures& f) { return f.shading(); }},
    {"film", "film", [](const FrameFigures& f) { return f.film; }},
    {"render", "render", [](const FrameFigures& f) { return f.render; }},
    {"write", "write", [](const FrameFigures& f) { return f.write; }},
};

}  // namespace

std::string table(std::span<const FrameFigures> frames) {
    std::string text = fmt::format("{:20} {:11}", "CPU s of one thread", "backend");
    for (const Column& c : seconds) text += fmt::format(" {:>7}", c.heading);
    text += "  ns/ray  overhead\n";
    for (const FrameFigures& f : frames) {
        text += fmt::format("{:20} {:11}", f.scene, f.backend);
        for (const Column& c : seconds) text += fmt::format(" {:7.3f}", c.value(f));
        const double nanoseconds = 1e9 * f.render / static_cast<double>(f.rays);
        text += fmt::format(" {:7.1f} {:9.2f}\n", nanoseconds, f.overhead());
    }
    text +=
        "inters.: the same rays by the intersector alone; shading: render less camera, inters. "
        "and film;\noverhead: render / inters.\n";
    return text;
}

nlohmann::ordered_json json_of(const FrameFigures& f) {
    nlohmann::ordered_json cpu;
    for (const Column& c : seconds) cpu[c.key] = c.value(f);
    return {{"scene", f.scene},   {"backend", f.backend},    {"width", f.width},
            {"height", f.height}, {"spp", f.samples},        {"rays", f.rays},
            {"cpu_seconds", cpu}, {"overhead", f.overhead()}};
}

}  // namespace etalon::frames
