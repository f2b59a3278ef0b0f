#pragma once

#include <csetjmp>
#include <string>

namespace etalon {

/// Non-local exit from a C library that reports errors by a function that must not return.
class LibraryJump {
  public:
    /// Calls `work` and returns whether it completed. Between `work` and leave() no frame may hold
    /// an object with a destructor, and what `work` changes must be declared outside of it.
    template <class Work>
    [[gnu::noinline]] bool completes(const Work& work) {
        if (setjmp(place_) != 0) return false;
        work();
        return true;
    }

    /// Ends the current call of completes(). The library's text has at most `capacity` characters,
    /// including the terminating zero.
    [[noreturn]] void leave() { std::longjmp(place_, 1); }

    static constexpr std::size_t capacity = 512;
    char reason[capacity] = {};  ///< reason of the jump, in the library's words

  private:
    std::jmp_buf place_;
};

}  // namespace etalon
