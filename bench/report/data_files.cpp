#include "bench/report/data_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/common/output.h"
#include "app/common/provenance.h"
#include "bench/accuracy/report/accuracy_json.h"
#include "bench/convergence/curve_report.h"
#include "bench/convergence/foreign_report.h"
#include "bench/frames/frame_report.h"
#include "bench/speed/report/speed_json.h"
#include "bench/table/csv.h"

namespace etalon::bench_report {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Machine& m) {
    return {{"processor", m.processor},
            {"cores", m.cores},
            {"memory_bytes", m.memory_bytes},
            {"system", m.system},
            {"load", m.load},
            {"version", m.version},
            {"commit", m.commit},
            {"compiler", m.compiler},
            {"flags", m.flags},
            {"embree", m.embree},
            {"embree_isa", m.embree_isa}};
}

Json json_of(const SpdFigures& spd) {
    Json json = {{"family", spd.family},
                 {"size", spd.size},
                 {"primitives", spd.primitives},
                 {"parse_cpu_seconds", spd.parse},
                 {"backends", Json::object()}};
    for (const SpdRun& run : spd.runs) {
        json["backends"][run.backend] = {{"build_cpu_seconds", run.build.cpu},
                                         {"render_cpu_seconds", run.render.cpu},
                                         {"accelerator_bytes", run.bytes},
                                         {"rays", run.counts.total()}};
    }
    return json;
}

Json json_of(const MeasuredFrame& frame) {
    constexpr const char* origins[] = {"shipped", "family", "given"};
    Json json = frames::json_of(frame.figures);
    json["origin"] = origins[static_cast<int>(frame.origin)];
    return json;
}

Json json_of(const ConvergenceFigures& figures) {
    Json json = {{"scene", figures.request.scene},
                 {"reference", figures.reference},
                 {"curves", Json::array()}};
    for (const convergence::Curve& curve : figures.curves) {
        json["curves"].push_back(convergence::json_of(curve));
    }
    return json;
}

Json json_of(const ForeignFigures& figures) {
    Json json = {{"scene", figures.scene},         {"missing", figures.missing},
                 {"reference", figures.reference}, {"same_image", figures.is_same},
                 {"foreign", Json::array()},       {"comparisons", Json::array()}};
    json["curve"] = Json::array();
    if (figures.missing.empty()) json["curve"].push_back(convergence::json_of(figures.own));
    for (const auto& curve : figures.foreign) {
        json["foreign"].push_back(convergence::json_of(curve));
    }
    for (const auto& comparison : figures.comparisons) {
        json["comparisons"].push_back(convergence::json_of(comparison));
    }
    return json;
}

Json json_of(const KeyFigure& figure) {
    return {{"value", figure.value}, {"name", figure.name}, {"note", figure.note}};
}

template <class List, class Convert>
Json list_of(const List& list, const Convert& convert) {
    Json json = Json::array();
    for (const auto& item : list) json.push_back(convert(item));
    return json;
}

Json data_of(const Results& results, const Page& page) {
    const auto own = [](const auto& figures) { return json_of(figures); };
    Json json = provenance();
    json.update({{"report", results.settings.name},
                 {"begun", results.begun},
                 {"missing", results.missing},
                 {"machine", json_of(results.machine)},
                 {"key_figures", list_of(page.summary, own)},
                 {"speed", list_of(results.scenes.list,
                                   [](const auto& scene) { return speed::json_of(scene); })},
                 {"accuracy", accuracy::json(results.rows.list)["rows"]},
                 {"frames", list_of(results.frames.list, own)},
                 {"spd", list_of(results.spd.list, own)},
                 {"convergence", list_of(results.convergence.list, own)},
                 {"foreign", list_of(results.foreign.list, own)}});
    return json;
}

/// "speed", "All numbers of this section" -> "speed-all-numbers-of-this-section.csv".
std::string csv_name(const Section& section, const Figure& figure) {
    std::string name = section.id;
    bool is_between = true;
    for (const char c : figure.title) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (is_plain && is_between) name += '-';
        if (is_plain) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        is_between = !is_plain;
    }
    return name + ".csv";
}

std::string csv_of(const Table& table) {
    std::vector<std::string> fields;
    for (const Column& column : table.columns) fields.push_back(column.name);
    std::string text = table::csv_line(fields);
    for (const std::vector<Cell>& row : table.rows) {
        fields.clear();
        for (const Cell& cell : row) fields.push_back(cell.text);
        text += table::csv_line(fields);
    }
    return text;
}

/// Returns the names of the files of the page's tables, and the tables.
std::map<std::string, const Table*> tables_of(const Page& page) {
    std::map<std::string, const Table*> tables;
    for (const Section& section : page.sections) {
        for (const Figure& figure : section.figures) {
            const auto* table = std::get_if<Table>(&figure.content);
            if (table != nullptr) tables[csv_name(section, figure)] = table;
        }
    }
    return tables;
}

}  // namespace

bool write_data(const std::string& folder, const Results& results, const Page& page) {
    return write_json((std::filesystem::path(folder) / "data.json").string(),
                      data_of(results, page));
}

bool is_file_of_report(const std::string& name, const Page& page) {
    if (name == "index.html" || name == "data.json") return true;
    return name.ends_with(".csv") &&
           std::ranges::any_of(page.sections, [&](const Section& section) {
               return name.starts_with(section.id + '-');
           });
}

bool write_tables(const std::string& folder, const Page& page) {
    const std::filesystem::path place(folder);
    bool written = true;
    for (const auto& [name, table] : tables_of(page)) {
        written = write_text((place / name).string(), csv_of(*table)) && written;
    }
    return written;
}

std::vector<std::string> old_tables(const std::string& folder, const Page& page) {
    const std::map<std::string, const Table*> tables = tables_of(page);
    std::set<std::string> found;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        const bool is_table = name.ends_with(".csv") && is_file_of_report(name, page);
        if (is_table && !tables.contains(name)) found.insert(name);
    }
    return {found.begin(), found.end()};
}

}  // namespace etalon::bench_report
