// The backends under test, and their reference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/intersect/intersector.h"
#include "core/scene/scene.h"

namespace etalon::test {

/// Returns all backends that promise the kernels' own hits.
std::vector<Backend> exact_backends();

const Backend& backend_named(std::string_view name);

/// Tests every primitive for this ray, with the one rule for ties. Written out here so that no
/// backend is compared with itself. The ray must be valid.
std::optional<Hit> brute_force(const Scene& scene, const Ray& ray);

/// Returns whether both are misses, or the same hit.
bool same(const Hit& a, const Hit& b);

bool same_bits(const std::optional<Hit>& a, const std::optional<Hit>& b);

/// Returns how the answer of `intersector` to `ray` differs from `expected`; empty if it does not.
std::string difference(const Intersector& intersector, const Ray& ray,
                       const std::optional<Hit>& expected);

}  // namespace etalon::test
