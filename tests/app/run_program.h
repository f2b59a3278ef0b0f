// Runs the program as a user does, in a folder of its own.
#pragma once

#include <string>

#include "tests/temporary_folder.h"

namespace etalon::test {

struct ProgramResult {
    int status;  ///< exit status; 128 + n if signal n ended it
    std::string out, err;
    std::size_t peak_bytes;
};

/// A new empty folder below the system's temporary one, removed at the end.
class Folder {
  public:
    std::string path(const std::string& name) const { return folder_ / name; }
    std::string write(const std::string& name, const std::string& text) const;
    bool has(const std::string& name) const;
    std::string read(const std::string& name) const;

    /// Runs `etalon ARGUMENTS` (a shell's words) here, with `input` on standard input.
    ProgramResult etalon(const std::string& arguments, const std::string& input = "") const;

    /// Runs a shell command here.
    ProgramResult shell(const std::string& command, const std::string& input = "") const;

  private:
    TemporaryFolder folder_;
};

/// Runs a program and sends it a signal as soon as `until`, a shell command, succeeds; "$pid" is
/// its process, "out" and "err" are what it has written.
ProgramResult interrupted(const Folder& f, const std::string& command, const std::string& until,
                          const std::string& signal = "INT");

/// Returns a command for interrupted() that succeeds once the program has used so many hundredths
/// of a second of processor time.
std::string has_worked(int hundredths);

/// A small complete P3F scene with a sphere, a plane, a light.
extern const std::string small_scene;

}  // namespace etalon::test
