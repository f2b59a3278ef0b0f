#include "bench/convergence/convergence_results.h"

#include <fmt/format.h>

#include "app/common/output.h"
#include "app/common/progress_line.h"
#include "app/common/provenance.h"
#include "bench/convergence/curve_report.h"
#include "bench/convergence/foreign_report.h"

namespace etalon::convergence {
namespace {

using Json = nlohmann::ordered_json;

constexpr int name_width = 40;

std::string heading_of(const Measured& m) {
    return fmt::format("{}, {} x {}; reference: {}; {} seeds\n\n", shortened(m.scene, name_width),
                       m.size.x, m.size.y, shortened(m.reference, name_width - 10), m.seeds);
}

template <class List>
std::string tables_of(const List& list) {
    std::string text;
    for (const auto& item : list) text += table_of(item) + "\n";
    return text;
}

std::string legend_of(const Measured& measured) {
    table::Legend legend;
    explain_curve(legend);
    if (!measured.foreign.empty()) explain_foreign(legend);
    return legend.text();
}

template <class List>
Json list_of(const List& list) {
    Json json = Json::array();
    for (const auto& item : list) json.push_back(json_of(item));
    return json;
}

Json json_of(const Measured& m, const std::vector<CurveComparison>& comparisons) {
    Json json = provenance();
    json["stopped"] = m.stopped.empty() ? Json() : Json(m.stopped);
    json["scene"] = m.scene;
    json["image"] = {{"width", m.size.x}, {"height", m.size.y}};
    json["reference"] = m.reference;
    json["seeds"] = m.seeds;
    json["curves"] = list_of(m.curves);
    json["foreign"] = list_of(m.foreign);
    json["comparisons"] = list_of(comparisons);
    return json;
}

bool write_files(const Measured& measured, const std::vector<CurveComparison>& comparisons,
                 const std::string& json, const std::string& csv) {
    bool written = true;
    if (!json.empty()) written = write_json(json, json_of(measured, comparisons));
    if (csv.empty()) return written;
    return write_text(csv, csv_of(measured.curves, measured.foreign, comparisons)) && written;
}

}  // namespace

bool write_results(const Measured& measured, const std::string& json, const std::string& csv) {
    const std::vector<CurveComparison> comparisons = compare(measured.curves, measured.foreign);
    write_table(csv == "-" ? csv : json,
                heading_of(measured) + tables_of(measured.curves) + tables_of(measured.foreign) +
                    tables_of(comparisons) +
                    (measured.stopped.empty() ? "" : "Stopped by a signal: not all curves.\n") +
                    legend_of(measured));
    return write_files(measured, comparisons, json, csv);
}

void keep_results(Measured measured, const std::string& json, const std::string& csv) {
    const auto replaceable = [](const std::string& path) {
        return is_replaceable(path) ? path : std::string();
    };
    measured.stopped = "error";
    write_files(measured, compare(measured.curves, measured.foreign), replaceable(json),
                replaceable(csv));
}

}  // namespace etalon::convergence
