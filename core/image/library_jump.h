#pragma once

#include <csetjmp>
#include <string>

namespace etalon {

/// The way out of a C library that reports an error by a function that must not return.
class LibraryJump {
  public:
    /// Calls `work` and returns whether it came to its end. Between `work` and leave() no frame may
    /// hold anything with a destructor, and what `work` changes must be declared outside of it.
    template <class Work>
    [[gnu::noinline]] bool completes(const Work& work) {
        if (setjmp(place_) != 0) return false;
        work();
        return true;
    }

    /// Ends the call of completes() that is under way. The library's text has no more than
    /// `capacity` characters with the zero at its end.
    [[noreturn]] void leave() { std::longjmp(place_, 1); }

    static constexpr std::size_t capacity = 512;
    char reason[capacity] = {};  ///< why there was a jump, in the library's words

  private:
    std::jmp_buf place_;
};

}  // namespace etalon
