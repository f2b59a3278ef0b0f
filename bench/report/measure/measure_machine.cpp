#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "app/common/program_facts.h"
#include "app/common/provenance.h"
#include "bench/report/tasks.h"
#include "embree_backend/embree_backends.h"

namespace etalon::bench_report {
namespace {

std::string system_name() {
    utsname name = {};
    if (uname(&name) != 0) return "unknown";
    return fmt::format("{} {}, {}", name.sysname, name.release, name.machine);
}

double memory_bytes() {
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Machine this_machine() {
    const BuildFacts& build = build_facts();
    const MachineFacts here = machine_facts();
    const EmbreeLibrary embree = embree_library();
    return {here.processor,
            system_name(),
            std::string(build.compiler),
            std::string(build.flags),
            std::string(build.version),
            std::string(build.commit),
            embree.version,
            embree.isa,
            here.cores,
            memory_bytes(),
            here.load_average};
}

}  // namespace etalon::bench_report
