#pragma once

#include <exception>
#include <future>
#include <vector>

#include "core/parallel/parallel.h"

namespace etalon {

/// Calls body() on as many threads as allowed, and returns when all have returned. For bodies that
/// wait for each other or for another process, which oneTBB's tasks must not. If not all threads
/// can be started, only half of those that were call it: the stacks of the rest took memory that
/// the body may need.
template <class Body>
void on_all_threads(const Body& body) {
    const auto run = [&] {
        const DefaultFloatEnvironment floats;
        body();
    };
    auto used = static_cast<std::size_t>(max_threads() - 1);
    std::promise<std::size_t> decision;
    std::promise<void> beginning;
    const std::shared_future<std::size_t> decided = decision.get_future().share();
    const std::shared_future<void> begun = beginning.get_future().share();
    std::vector<std::future<void>> others;
    others.reserve(used);
    try {
        while (others.size() < used) {
            const auto wait_and_run = [&run, decided, begun, number = others.size()] {
                if (number >= decided.get()) return;
                begun.wait();
                run();
            };
            others.push_back(std::async(std::launch::async, wait_and_run));
        }
    } catch (const std::exception&) {
        used = others.size() / 2;
    }
    decision.set_value(used);
    others.resize(used);  // waits for the end of those that are not used
    beginning.set_value();
    run();
    for (std::future<void>& other : others) other.get();
}

}  // namespace etalon
