// The rows of a report grouped by shape, then by case, in order of appearance.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/accuracy/error_stats.h"
#include "core/intersect/backend_roles.h"

namespace etalon::accuracy {

/// Rows of all tracers for one case. The rows must outlive it.
struct CaseRows {
    std::string name() const;  ///< "SPH-1, 1e3 radii"

    /// Returns the tracer's row, or nullptr if it was not measured.
    const Row* find(std::string_view tracer) const;

    /// Returns the first row with the most rays: some tracers are given fewer.
    const Row& fullest() const;

    std::string id, variant, criterion;
    std::vector<const Row*> rows;
};

std::vector<std::string> shapes_of(const std::vector<Row>& rows);
std::vector<CaseRows> cases_of(const std::vector<Row>& rows, const std::string& shape);

/// Names of tracers that the report uses.
inline constexpr std::string_view baseline = baseline_backend;
inline constexpr std::string_view bare_kernel = "kernel";

/// Returns whether a tracer of that name is one of textbook_tracers().
bool is_textbook(std::string_view tracer);

/// Returns the number of all errors, per million decided rays.
double errors_per_million(const ErrorStats& stats);

}  // namespace etalon::accuracy
