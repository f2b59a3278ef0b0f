// A library to preload into a program under test: once it has opened the file whose name ends in
// FAILS_AFTER, or from main() on where that is empty, the calls that ask for memory, or with
// FAILS=thread those that start threads, are counted, and the one numbered FAILS_AT fails, from 1.
// FAILS_AT=0 lets all succeed; how many there were is written to the file FAILS_COUNT when the
// program ends.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
}

namespace {

std::atomic<bool> is_counting = false;
std::atomic<long> calls = 0;
long fails_at = 0;
bool of_threads = false;

using Main = int (*)(int, char**, char**);
Main program = nullptr;

bool fails(bool starts_thread) {
    if (!is_counting || starts_thread != of_threads) return false;
    if (++calls != fails_at) return false;
    errno = starts_thread ? EAGAIN : ENOMEM;
    return true;
}

bool ends_with(const char* text, const char* end) {
    const size_t size = strlen(text), length = strlen(end);
    return size >= length && strcmp(text + size - length, end) == 0;
}

void note_opened(const char* path) {
    const char* last = getenv("FAILS_AFTER");
    if (last != nullptr && ends_with(path, last)) is_counting = true;
}

/// Reads the environment before the program does anything, and counts no allocation of that.
__attribute__((constructor)) void prepare() {
    const char* at = getenv("FAILS_AT");
    const char* what = getenv("FAILS");
    fails_at = at != nullptr ? atol(at) : 0;
    of_threads = what != nullptr && strcmp(what, "thread") == 0;
}

/// Nothing could report a failure in the initializers of libraries, before this.
int counting_main(int count, char** arguments, char** environment) {
    const char* after = getenv("FAILS_AFTER");
    is_counting = after != nullptr && *after == '\0';
    return program(count, arguments, environment);
}

__attribute__((destructor)) void report() {
    is_counting = false;
    const char* path = getenv("FAILS_COUNT");
    if (path == nullptr) return;
    char text[32];
    const int size = snprintf(text, sizeof text, "%ld\n", calls.load());
    const int file = creat(path, 0666);
    if (write(file, text, static_cast<size_t>(size)) != size) abort();
    close(file);
}

}  // namespace

extern "C" {

int __libc_start_main(Main main, int count, char** arguments, void (*begin)(), void (*end)(),
                      void (*end_of_loader)(), void* stack) {
    using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
    const auto real = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
    program = main;
    return real(counting_main, count, arguments, begin, end, end_of_loader, stack);
}

int open(const char* path, int flags, ...) {
    using Open = int (*)(const char*, int, ...);
    static const auto real = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "open"));
    va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    const int file = real(path, flags, mode);
    note_opened(path);
    return file;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* value) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto real = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    return fails(true) ? EAGAIN : real(thread, attributes, run, value);
}

void* malloc(size_t size) noexcept {
    return fails(false) ? nullptr : __libc_malloc(size);
}

void* calloc(size_t count, size_t size) noexcept {
    return fails(false) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, size_t size) noexcept {
    return fails(false) ? nullptr : __libc_realloc(memory, size);
}

void* memalign(size_t alignment, size_t size) noexcept {
    return fails(false) ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(size_t alignment, size_t size) noexcept {
    return memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size) noexcept {
    if (fails(false)) return ENOMEM;
    *memory = __libc_memalign(alignment, size);
    return *memory != nullptr ? 0 : ENOMEM;
}
}
