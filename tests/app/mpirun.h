#pragma once

#include <string>

#include "tests/app/run_program.h"
#include "tests/sanitized.h"

namespace etalon::test {

inline bool has_mpirun(const Folder& f) {
    return f.shell("mpirun --version").status == 0;
}

/// Begins a shell command that loads Open MPI, whose leaks are not reported: the modules that they
/// are in are no longer loaded then, so that no suppression can name them.
inline constexpr const char* with_mpi = is_sanitized ? "env ASAN_OPTIONS=detect_leaks=0 " : "";

/// Returns the beginning of a shell command that runs a program in so many ranks.
inline std::string mpirun(int ranks) {
    return std::string(with_mpi) + "mpirun --allow-run-as-root --oversubscribe -n " +
           std::to_string(ranks) + " ";
}

}  // namespace etalon::test
