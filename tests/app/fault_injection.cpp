// A library to preload into a program under test: the n-th call that writes to a file which is made
// beside its place (see core/image/file_replacement.h), or puts it there, fails or kills the
// program. FAULT=N:kill, N:ERRNO (that call alone) or N+:ERRNO (that one and all after it).
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
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

/// Whether this call fails; errno is set.
bool fails() {
    const char* fault = getenv("FAULT");
    if (fault == nullptr) return false;
    char* rest = nullptr;
    const int at = static_cast<int>(strtol(fault, &rest, 10));
    const int call = ++calls;
    const bool goes_on = *rest == '+';
    if (goes_on) ++rest;
    if (goes_on ? call < at : call != at) return false;
    if (strcmp(rest, ":kill") == 0) kill(getpid(), SIGKILL);
    errno = atoi(rest + 1);
    return true;
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
    if (is_made_beside(file) && fails()) {
        const int error = errno;
        if (error == ENOSPC && size > 1) real(file, bytes, size / 2);
        errno = error;
        return -1;
    }
    return real(file, bytes, size);
}

int fsync(int file) {
    static const auto real = next<int (*)(int)>("fsync");
    return is_made_beside(file) && fails() ? -1 : real(file);
}

int ftruncate(int file, off_t size) noexcept {
    static const auto real = next<int (*)(int, off_t)>("ftruncate");
    return is_made_beside(file) && fails() ? -1 : real(file, size);
}

int rename(const char* from, const char* to) noexcept {
    static const auto real = next<int (*)(const char*, const char*)>("rename");
    return is_made_beside(from) && fails() ? -1 : real(from, to);
}
}
