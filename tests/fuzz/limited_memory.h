#pragma once

#include <cstdint>

namespace etalon::fuzz {

/// Limits each allocation to 1 MiB during its lifetime, like --max-memory.
class LimitedMemory {
  public:
    /// Also makes call number `failing_call` of operator new throw; 0: no call.
    explicit LimitedMemory(std::uint32_t failing_call = 0);
    ~LimitedMemory();

    /// Returns whether that call has been made.
    bool has_failed() const;

    LimitedMemory(const LimitedMemory&) = delete;
    LimitedMemory& operator=(const LimitedMemory&) = delete;
};

}  // namespace etalon::fuzz
