#pragma once

namespace etalon {

/// Rank of a process among those that an MPI launcher, such as mpirun, started together.
struct StartedRank {
    int rank = 0;
    int size = 1;  ///< 0 if the launcher does not say
};

/// Reads it from the environment. A process that was started alone is the only rank.
StartedRank started_rank();

}  // namespace etalon
