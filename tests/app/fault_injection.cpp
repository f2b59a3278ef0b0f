// A library to preload into a program under test: the n-th call that opens, or writes to, a file
// which is made beside its place (see core/image/file_replacement.h), or puts it there, fails or
// kills the program. FAULT=N:kill, N:ERRNO (that call alone), N+:ERRNO (that one and all after it)
// or N%:ERRNO (each n-th). In place of a failure, "half" writes a part of the bytes, as the system
// may.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace {

std::atomic<int> calls = 0;

bool is_made_beside(const char* path) {
    return strstr(path, "/.etalon-") != nullptr || strncmp(path, ".etalon-", 8) == 0;
}

bool is_made_beside(int file) {
    char link[64], path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t size = readlink(link, path, sizeof path - 1);
    path[size < 0 ? 0 : size] = 0;
    return is_made_beside(path);
}

enum class Fault { none, failure, half };

/// Returns what befalls this call; errno is set for a failure.
Fault fault() {
    const char* wanted = getenv("FAULT");
    if (wanted == nullptr) return Fault::none;
    char* rest = nullptr;
    const int at = static_cast<int>(strtol(wanted, &rest, 10));
    const int call = ++calls;
    const char how = *rest;
    if (how == '+' || how == '%') ++rest;
    if (how == '+' ? call < at : how == '%' ? call % at != 0 : call != at) return Fault::none;
    if (strcmp(rest, ":kill") == 0) kill(getpid(), SIGKILL);
    if (strcmp(rest, ":half") == 0) return Fault::half;
    errno = atoi(rest + 1);
    return Fault::failure;
}

bool fails() {
    return fault() == Fault::failure;
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

/// A write that fails for want of space leaves half of its bytes first.
ssize_t write(int file, const void* bytes, size_t size) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
    const Fault now = is_made_beside(file) ? fault() : Fault::none;
    if (now == Fault::none) return real(file, bytes, size);
    if (now == Fault::half) return real(file, bytes, (size + 1) / 2);
    const int error = errno;
    if (error == ENOSPC && size > 1) real(file, bytes, size / 2);
    errno = error;
    return -1;
}

/// Programs of 64 bits call it whether they are compiled for large files or not.
int open(const char* path, int flags, ...) {
    static const auto real = next<int (*)(const char*, int, ...)>("open");
    va_list rest;
    va_start(rest, flags);
    const auto mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return is_made_beside(path) && fails() ? -1 : real(path, flags, mode);
}

int fsync(int file) {
    static const auto real = next<int (*)(int)>("fsync");
    return is_made_beside(file) && fails() ? -1 : real(file);
}

int ftruncate(int file, off_t size) noexcept {
    static const auto real = next<int (*)(int, off_t)>("ftruncate");
    return is_made_beside(file) && fails() ? -1 : real(file, size);
}

/// Signals do not interrupt it.
int rename(const char* from, const char* to) noexcept {
    static const auto real = next<int (*)(const char*, const char*)>("rename");
    return is_made_beside(from) && fails() && errno != EINTR ? -1 : real(from, to);
}
}
