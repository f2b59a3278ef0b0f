#include "core/formats/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace etalon {
namespace {

const char* name(Severity severity) {
    return severity == Severity::error ? "error" : "warning";
}

/// The diagnostics of one kind and severity seen so far.
struct Tally {
    const Diagnostic* first;
    int shown = 0;
    std::size_t hidden = 0;
};

Tally& tally_of(const Diagnostic& d, std::vector<Tally>& tallies) {
    const auto same = [&](const Tally& t) {
        return t.first->kind == d.kind && t.first->severity == d.severity;
    };
    const auto found = std::find_if(tallies.begin(), tallies.end(), same);
    return found != tallies.end() ? *found : tallies.emplace_back(Tally{&d});
}

}  // namespace

std::string to_string(const Diagnostic& d) {
    if (d.line == 0) return fmt::format("{}: {}: {}", d.file, name(d.severity), d.message);
    return fmt::format("{}:{}:{}: {}: {}", d.file, d.line, d.column, name(d.severity), d.message);
}

std::string report(const std::vector<Diagnostic>& diagnostics, int limit) {
    std::string text;
    std::vector<Tally> tallies;
    for (const Diagnostic& d : diagnostics) {
        Tally& tally = tally_of(d, tallies);
        tally.hidden += d.more;
        if (tally.shown == limit) {
            ++tally.hidden;
        } else {
            ++tally.shown;
            text += to_string(d) + '\n';
        }
    }
    for (const Tally& t : tallies) {
        if (t.hidden == 0) continue;
        fmt::format_to(std::back_inserter(text), "{}: {}: {} more of this kind ({})\n",
                       t.first->file, name(t.first->severity), t.hidden, t.first->kind);
    }
    return text;
}

}  // namespace etalon
