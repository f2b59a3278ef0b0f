#include "core/formats/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/printable.h"

namespace etalon {
namespace {

/// Bytes of a message that are shown, and of its file's name.
constexpr std::size_t longest_message = 2000, longest_name = 1000;

const char* name(Severity severity) {
    return severity == Severity::error ? "error" : "warning";
}

/// The diagnostics of one kind and severity seen so far.
struct KindCount {
    const Diagnostic* first;
    int shown = 0;
    std::size_t hidden = 0;
};

KindCount& count_of(const Diagnostic& d, std::vector<KindCount>& counts) {
    const auto same = [&](const KindCount& t) {
        return t.first->kind == d.kind && t.first->severity == d.severity;
    };
    const auto found = std::find_if(counts.begin(), counts.end(), same);
    return found != counts.end() ? *found : counts.emplace_back(KindCount{&d});
}

}  // namespace

std::string to_string(const Diagnostic& d) {
    const std::string file = printable(d.file, longest_name);
    const std::string message = printable(d.message, longest_message);
    if (d.line == 0) return fmt::format("{}: {}: {}", file, name(d.severity), message);
    return fmt::format("{}:{}:{}: {}: {}", file, d.line, d.column, name(d.severity), message);
}

std::string report(const std::vector<Diagnostic>& diagnostics, int limit) {
    std::string text;
    std::vector<KindCount> counts;
    for (const Diagnostic& d : diagnostics) {
        KindCount& count = count_of(d, counts);
        count.hidden += d.more;
        if (count.shown == limit) {
            ++count.hidden;
        } else {
            ++count.shown;
            text += to_string(d) + '\n';
        }
    }
    for (const KindCount& t : counts) {
        if (t.hidden == 0) continue;
        text += fmt::format("{}: {}: {} more of this kind ({})\n",
                            printable(t.first->file, longest_name), name(t.first->severity),
                            t.hidden, t.first->kind);
    }
    return text;
}

}  // namespace etalon
