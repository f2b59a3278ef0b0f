// Provenance of a result: the program and its command line, the machine, and Embree.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace etalon {

/// Version of the JSON formats. It changes when a key is renamed or removed, or its meaning
/// changes.
inline constexpr int json_schema = 1;

/// The machine on which the program runs.
struct MachineFacts {
    std::string processor;    ///< as the system names it, or "unknown"
    int cores = 0;            ///< number that this process may use
    double load_average = 0;  ///< of the last minute, including other processes; 0 if unknown
    std::string isa;          ///< best compiled instruction set that it has, "avx2"
};
MachineFacts machine_facts();

/// Returns the beginning of every JSON of a measurement: "schema", the build, "command", "machine"
/// and "embree". Throws as embree_library() does.
nlohmann::ordered_json provenance();

/// Returns the lines of --version beside the build: Embree and the instruction set.
std::string library_lines();

}  // namespace etalon
