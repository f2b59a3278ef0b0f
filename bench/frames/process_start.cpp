#include "bench/frames/process_start.h"

#include "core/base/clocks.h"

namespace etalon::frames {
namespace {

double before_main = 0;

}  // namespace

void note_begin_of_main() {
    before_main = process_cpu_seconds();
}

double seconds_before_main() {
    return before_main;
}

}  // namespace etalon::frames
