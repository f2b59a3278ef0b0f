// Timing of rays through an intersector.
#pragma once

#include <span>

#include "app/common/stopwatch.h"
#include "bench/accuracy/tracer.h"
#include "core/test_rays/ray_sets.h"

namespace etalon::speed {

using accuracy::Answer;
using accuracy::missed;

/// Traces all rays of the set on so many pinned threads. For a set of occlusion queries, primitive
/// 0 means occluded.
Duration trace(const Intersector& intersector, const RaySet& set, int threads,
               std::span<Answer> answers);

}  // namespace etalon::speed
