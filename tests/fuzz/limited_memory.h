#pragma once

#include <cstdint>

namespace etalon::fuzz {

/// While there is one, no piece of memory is larger than 1 MiB, as if --max-memory had been given.
class LimitedMemory {
  public:
    /// Lets the operator new also throw once, at its call of this number; 0: at none.
    explicit LimitedMemory(std::uint32_t failing_call = 0);
    ~LimitedMemory();

    /// Whether the call of that number has come.
    bool has_failed() const;

    LimitedMemory(const LimitedMemory&) = delete;
    LimitedMemory& operator=(const LimitedMemory&) = delete;
};

}  // namespace etalon::fuzz
