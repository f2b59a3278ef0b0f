#pragma once

namespace etalon {

/// Exit status of the programs.
enum ExitStatus : int {
    exit_done = 0,
    exit_differs = 1,      ///< a comparison or cross-check found more than it allows
    exit_usage = 2,        ///< wrong usage
    exit_unusable = 3,     ///< the scene, or another input, is unusable
    exit_not_written = 4,  ///< output could not be written
    exit_signal = 128,     ///< plus the signal's number
};

}  // namespace etalon
