#include "app/common/started_rank.h"

#include <cstdlib>
#include <initializer_list>
#include <optional>

namespace etalon {
namespace {

/// Returns the value of the first of these variables that is set.
std::optional<int> first_of(std::initializer_list<const char*> names) {
    for (const char* name : names) {
        if (const char* value = std::getenv(name)) return std::atoi(value);
    }
    return std::nullopt;
}

}  // namespace

/// Open MPI's mpirun sets the first ones, srun with PMIx or PMI-2 the others.
StartedRank started_rank() {
    const auto rank = first_of({"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"});
    if (!rank) return {};
    return {*rank,
            first_of({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}).value_or(0)};
}

}  // namespace etalon
