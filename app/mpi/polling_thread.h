#pragma once

#include <functional>
#include <thread>

#include "app/mpi/poll_pause.h"

namespace etalon {

/// A thread that polls for messages during its lifetime, and sleeps in between: it takes hardly any
/// time from the threads that render.
class PollingThread {
  public:
    /// `look` returns whether there was anything to do. It must not throw.
    explicit PollingThread(std::function<bool()> look)
        : thread_([look = std::move(look)](const std::stop_token& over) {
              PollPause pause;
              while (!over.stop_requested()) {
                  if (look()) {
                      pause.reset();
                  } else {
                      pause.sleep();
                  }
              }
          }) {}

  private:
    std::jthread thread_;  ///< its destructor requests a stop and joins
};

}  // namespace etalon
