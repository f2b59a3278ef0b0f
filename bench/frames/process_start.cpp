#include "bench/frames/process_start.h"

#include <ctime>

namespace etalon::frames {
namespace {

double before_main = 0;

}  // namespace

void note_begin_of_main() {
    timespec t = {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    before_main = static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double seconds_before_main() {
    return before_main;
}

}  // namespace etalon::frames
