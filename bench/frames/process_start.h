// Cost of starting a process.
#pragma once

namespace etalon::frames {

/// Records the processor time so far. Must be the first statement of main.
void note_begin_of_main();

/// Returns the seconds of processor time before main, for loading and linking the program and
/// initializing static objects. 0 in a program whose main does not call note_begin_of_main().
double seconds_before_main();

}  // namespace etalon::frames
