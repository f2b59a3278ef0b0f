// The report as one HTML file that needs nothing else: no script, no network.
#pragma once

#include <string>

#include "bench/report/content.h"

namespace etalon::bench_report {

std::string html(const Page& page);

/// Returns the content of a <figure> without its caption. There is one overload for each content.
std::string html(const Table& table);
std::string html(const Bars& bars);
std::string html(const Charts& charts);
std::string html(const Images& images);

/// Returns the page's CSS, without that of its plots.
std::string style_sheet();

/// Encodes as base64 (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace etalon::bench_report
