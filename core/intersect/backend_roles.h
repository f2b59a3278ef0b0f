// The parts that single backends play in the programs, so that their names stand here and in their
// own tables alone.
#pragma once

namespace etalon {

/// Finds the hits where neither scene nor user names a backend; reports show it before others.
inline constexpr const char* default_backend = "bvh";

/// Tests every primitive against every ray: exact with nothing that could be wrong, and slow.
inline constexpr const char* reference_backend = "none";

/// Exact, and shares no tree with the default backend: what its hits are compared with where the
/// reference takes too long.
inline constexpr const char* second_backend = "embree-user";

/// Not exact; what speeds are measured against.
inline constexpr const char* baseline_backend = "embree-builtin";

}  // namespace etalon
