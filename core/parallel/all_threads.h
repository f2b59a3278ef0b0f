#pragma once

#include <future>
#include <vector>

#include "core/parallel/parallel.h"

namespace etalon {

/// Calls body() on as many threads as allowed, and returns when all have returned. For bodies that
/// wait for each other or for another process, which oneTBB's tasks must not.
template <class Body>
void on_all_threads(const Body& body) {
    const auto run = [&] {
        const DefaultFloatEnvironment floats;
        body();
    };
    std::vector<std::future<void>> others;
    for (int i = 1; i < max_threads(); ++i) others.push_back(std::async(std::launch::async, run));
    run();
    for (std::future<void>& other : others) other.get();
}

}  // namespace etalon
