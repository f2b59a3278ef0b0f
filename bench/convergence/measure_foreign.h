#pragma once

#include "bench/convergence/foreign_table.h"
#include "bench/convergence/measure_curves.h"

namespace etalon::convergence {

/// Measures images of other programs against a reference, by the metrics of our own curves, on the
/// pixels of the settings. Returns a curve for each program. A failure's reason begins with the
/// table's line whose image cannot be read or has another size.
Result<std::vector<ForeignCurve>> measure_foreign(const std::vector<ForeignImage>& images,
                                                  const ReferenceImage& reference,
                                                  const RenderSettings& settings);

}  // namespace etalon::convergence
