// Roles of single backends in the programs. A name of a backend stands only here and in the tables
// of backends.
#pragma once

namespace etalon {

/// Backend used where neither scene nor user names one; reports list it first.
inline constexpr const char* default_backend = "bvh";

/// Tests every primitive against every ray: slow, but so simple that nothing in it can be wrong.
inline constexpr const char* reference_backend = "none";

/// Exact backend to check the default one against where the reference takes too long. The two have
/// no tree in common.
inline constexpr const char* second_backend = "embree-user";

/// Baseline that speeds are measured against. It is not exact.
inline constexpr const char* baseline_backend = "embree-builtin";

}  // namespace etalon
