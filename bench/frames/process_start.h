// What a process costs before it does anything.
#pragma once

namespace etalon::frames {

/// Records the time that the process has used until now. The first statement of main.
void note_begin_of_main();

/// Returns the seconds of processor time before main: loading and linking the program and
/// initializing what is static. 0 in a program whose main does not note its begin.
double seconds_before_main();

}  // namespace etalon::frames
