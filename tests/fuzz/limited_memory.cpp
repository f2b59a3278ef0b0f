// Operators new that throw when memory is exhausted. Those of the address sanitizer end the program
// instead.
#include "tests/fuzz/limited_memory.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

/// Largest single allocation in bytes. It saves clearing and poisoning the huge blocks that a
/// damaged header asks for.
constexpr std::size_t most = std::size_t{1} << 20;
std::atomic<bool> is_limited = false;
constexpr auto usual = static_cast<std::align_val_t>(__STDCPP_DEFAULT_NEW_ALIGNMENT__);

/// Number of calls until one fails; 0: none does.
std::atomic<std::int64_t> calls_left = 0;

/// Allocates memory. Returns null on failure.
void* memory_of(std::size_t size, std::align_val_t alignment) noexcept {
    if (calls_left.load(std::memory_order_relaxed) > 0 && --calls_left == 0) return nullptr;
    if (size > most && is_limited) return nullptr;
    void* memory = nullptr;
    const std::size_t unit = std::max(static_cast<std::size_t>(alignment), sizeof(void*));
    return ::posix_memalign(&memory, unit, size) == 0 ? memory : nullptr;
}

void* not_null(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

namespace etalon::fuzz {

LimitedMemory::LimitedMemory(std::uint32_t failing_call) {
    is_limited = true;
    calls_left = failing_call;
}

LimitedMemory::~LimitedMemory() {
    is_limited = false;
    calls_left = 0;
}

bool LimitedMemory::has_failed() const {
    return calls_left <= 0;
}

}  // namespace etalon::fuzz

// clang-format off
void* operator new(std::size_t size) { return not_null(memory_of(size, usual)); }
void* operator new[](std::size_t size) { return not_null(memory_of(size, usual)); }
void* operator new(std::size_t size, std::align_val_t a) { return not_null(memory_of(size, a)); }
void* operator new[](std::size_t size, std::align_val_t a) { return not_null(memory_of(size, a)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return memory_of(size, usual); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return memory_of(size, usual); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
// clang-format on

/// Limits allocations of C libraries to a size above that of libFuzzer's own tables. The quarantine
/// of freed memory is small, since memory that is reused soon is still in the caches.
extern "C" const char* __asan_default_options() {
    return "max_allocation_size_mb=64:allocator_may_return_null=1:quarantine_size_mb=4";
}
