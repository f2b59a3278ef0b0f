#include "app/common/provenance.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/common/program_facts.h"
#include "embree_backend/embree_backends.h"
#include "native_accel/common/isa.h"

namespace etalon {
namespace {

/// Returns the processor's name as Linux reports it, or "unknown".
std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

double load_average() {
    double load = 0;
    getloadavg(&load, 1);
    return load;
}

}  // namespace

MachineFacts machine_facts() {
    return {processor(), tbb::info::default_concurrency(), load_average(), traversal_isa()};
}

nlohmann::ordered_json provenance() {
    const BuildFacts& build = build_facts();
    const MachineFacts machine = machine_facts();
    const EmbreeLibrary embree = embree_library();
    return {{"schema", json_schema},
            {"version", build.version},
            {"commit", build.commit},
            {"compiler", build.compiler},
            {"flags", build.flags},
            {"command", command_line()},
            {"machine",
             {{"cpu", machine.processor},
              {"cores", machine.cores},
              {"load_average", machine.load_average},
              {"isa", machine.isa}}},
            {"embree",
             {{"version", embree.version},
              {"compiled_version", embree.compiled_version},
              {"isa", embree.isa}}}};
}

std::string library_lines() {
    const EmbreeLibrary embree = embree_library();
    return fmt::format("embree {} ({}), compiled for {}\ninstruction set {}", embree.version,
                       embree.isa, embree.compiled_version, traversal_isa());
}

}  // namespace etalon
