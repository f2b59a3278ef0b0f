// What made a result: the program and how it was called, the machine, and Embree.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace etalon {

/// The number that changes when a key of a JSON is renamed or removed, or its meaning changes.
inline constexpr int json_schema = 1;

/// The machine on which the program runs.
struct MachineFacts {
    std::string processor;    ///< as the system names it, or "unknown"
    int cores = 0;            ///< that this process may use
    double load_average = 0;  ///< of the last minute, other processes included; 0 if unknown
    std::string isa;          ///< the best that this machine has of those compiled, "avx2"
};
MachineFacts machine_facts();

/// Returns what every JSON of a measurement begins with: "schema", the build, "command", "machine"
/// and "embree". Throws as embree_library() does.
nlohmann::ordered_json provenance();

/// Returns what --version says beside the build: Embree and the instruction set, a line each.
std::string library_lines();

}  // namespace etalon
