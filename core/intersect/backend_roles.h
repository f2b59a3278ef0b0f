// Roles that single backends have in the programs, so that their names stand here and in their
// own tables alone.
#pragma once

namespace etalon {

/// Finds the hits where neither scene nor user names a backend; reports show it before others.
inline constexpr const char* default_backend = "bvh";

/// Tests every primitive against every ray: exact with nothing that could be wrong, and slow.
inline constexpr const char* reference_backend = "none";

/// Backend to compare the default one's hits with where the reference takes too long: exact, and
/// without a tree in common.
inline constexpr const char* second_backend = "embree-user";

/// Baseline that speeds are measured against; not exact.
inline constexpr const char* baseline_backend = "embree-builtin";

}  // namespace etalon
