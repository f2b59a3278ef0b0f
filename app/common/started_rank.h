#pragma once

namespace etalon {

/// Place of a process among those that an MPI launcher, such as mpirun, started together.
struct StartedRank {
    int rank = 0;
    int size = 1;  ///< 0: the launcher does not say how many there are
};

/// Reads it from the environment. A process that was started alone is the only one.
StartedRank started_rank();

}  // namespace etalon
