#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>

#include "bench/accuracy/report/accuracy_json.h"
#include "bench/report/tasks.h"
#include "bench/speed/pinned.h"
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

double load_average() {
    double load = 0;
    getloadavg(&load, 1);
    return load;
}

}  // namespace

Machine this_machine() {
    const accuracy::RunEnvironment here = accuracy::run_environment();
    const EmbreeLibrary embree = embree_library();
    return {here.machine,   system_name(), here.compiler,         here.flags,     here.version,
            embree.version, embree.isa,    speed::usable_cores(), memory_bytes(), load_average()};
}

}  // namespace etalon::bench_report
