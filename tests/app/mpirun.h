#pragma once

#include <string>

#include "tests/app/run_program.h"
#include "tests/sanitized.h"

namespace etalon::test {

inline bool has_mpirun(const Folder& f) {
    return f.shell("mpirun --version").status == 0;
}

/// Returns the beginning of a shell command that runs a program in so many ranks. Open MPI's leaks
/// are not reported: its modules, whose they are, are no longer loaded then, so that no suppression
/// can name them.
inline std::string mpirun(int ranks) {
    const std::string without_reports = is_sanitized ? "env ASAN_OPTIONS=detect_leaks=0 " : "";
    return without_reports + "mpirun --allow-run-as-root --oversubscribe -n " +
           std::to_string(ranks) + " ";
}

}  // namespace etalon::test
