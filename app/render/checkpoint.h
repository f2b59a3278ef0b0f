// A file from which a rendering can be resumed. It has two lines of text, a title and the identity
// of the image as JSON; then the state's bytes and a hash of all of this.
#pragma once

#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/clocks.h"
#include "core/base/hash64.h"
#include "core/render/renderer.h"

namespace etalon {

/// Writes the state to a file at regular intervals, and takes at most a fiftieth of the time for
/// it. If that fails there is a warning, the file stays unchanged, and rendering goes on.
class CheckpointWriter : public StateKeeper {
  public:
    using Clock = double (*)();  ///< seconds since any fixed moment; thread-safe

    CheckpointWriter(std::string path, double every, const nlohmann::ordered_json& identity,
                     Clock clock = wall_seconds);

    /// Sets the time of the first checkpoint.
    void begin_after(double seconds) { due_ = clock_() + seconds; }

    bool is_due() override;
    void keep(const std::function<void(StateWriter&)>& save) override;

    int written() const { return written_; }     ///< number of files written
    double seconds() const { return seconds_; }  ///< time that writing took

  private:
    std::string write(const std::function<void(StateWriter&)>& save) const;
    void report(const std::string& error);

    std::string path_, identity_, error_;
    double every_;
    Clock clock_;
    std::atomic<double> due_;        ///< time of the next write
    std::atomic<double> paused_{0};  ///< time since which threads have been waiting; 0 if none
    int written_ = 0;
    double seconds_ = 0;
};

/// Reads such a file.
class CheckpointReader {
  public:
    /// Returns why nothing can be resumed from the file, beginning with its name, or an empty
    /// string.
    std::string open(const std::string& path, const nlohmann::ordered_json& identity);

    /// Returns the state. May be called once, after open().
    StateReader state();

  private:
    std::ifstream file_;
    std::uint64_t left_ = 0;  ///< remaining bytes of the state
};

}  // namespace etalon
