#pragma once

#include <vector>

#include "core/intersect/clusters/clusters.h"
#include "embree_backend/device.h"

namespace etalon {

/// Primitives in groups, of which Embree is to see only the boxes.
struct Grouping {
    std::vector<std::uint32_t> ids;  ///< primitive numbers in the order of the groups
    std::vector<Range> ranges;       ///< of ids, one for each group
    std::vector<Box3f> boxes;        ///< one for each group
};

/// Adds `primitives`, of which it needs lower, upper and primID, to `groups` in groups of at most
/// `most`, nearly all of them full, by Embree's builder: surface area heuristic in blocks of so
/// many. On the threads of the caller's TBB arena, as many as it may use. Throws as
/// EmbreeDevice does.
void group(const EmbreeDevice& device, std::vector<RTCBuildPrimitive> primitives, unsigned most,
           Grouping& groups);

}  // namespace etalon
