// A file that a rendering can be resumed from. It begins with two lines of text: what it is, and
// the identity of the image as JSON; then come the state's bytes and a hash of all of this.
#pragma once

#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/hash64.h"
#include "core/render/renderer.h"

namespace etalon {

/// Writes the state to a file every so many seconds, and takes at most a fiftieth of the time for
/// it. Where that fails there is a warning, the file stays as it was, and rendering goes on.
class CheckpointWriter : public StateKeeper {
  public:
    using Clock = double (*)();  ///< seconds since any fixed moment, from any thread

    CheckpointWriter(std::string path, double every, const nlohmann::ordered_json& identity,
                     Clock clock = wall_seconds);

    /// Makes the first one due after so many seconds.
    void begin_after(double seconds) { due_ = clock_() + seconds; }

    bool is_due() override;
    void keep(const std::function<void(StateWriter&)>& save) override;

    int written() const { return written_; }     ///< number of files written
    double seconds() const { return seconds_; }  ///< that all this took
    static double wall_seconds();

  private:
    std::string write(const std::function<void(StateWriter&)>& save) const;
    void report(const std::string& error);

    std::string path_, identity_, error_;
    double every_;
    Clock clock_;
    std::atomic<double> due_;        ///< when to write next
    std::atomic<double> paused_{0};  ///< since when threads have been waiting; 0: they are not
    int written_ = 0;
    double seconds_ = 0;
};

/// Reads such a file.
class CheckpointReader {
  public:
    /// Returns why nothing can be resumed from the file, beginning with its name, or nothing.
    std::string open(const std::string& path, const nlohmann::ordered_json& identity);

    /// The state. To be called once, after open().
    StateReader state();

  private:
    std::ifstream file_;
    std::uint64_t left_ = 0;  ///< bytes of the state
};

}  // namespace etalon
