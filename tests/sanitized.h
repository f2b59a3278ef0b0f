// What tests leave out under a sanitizer.
#pragma once

#ifdef ETALON_SANITIZED
inline constexpr bool is_sanitized = true;
#define ETALON_LONG_IF_SANITIZED "[long]"
#else
inline constexpr bool is_sanitized = false;
/// Tag of a test case that runs the same code so often that it takes minutes under a sanitizer.
#define ETALON_LONG_IF_SANITIZED ""
#endif

#ifdef __SANITIZE_THREAD__
inline constexpr bool is_thread_sanitized = true;
#else
inline constexpr bool is_thread_sanitized = false;
#endif

/// What a test case skips under a sanitizer for.
inline constexpr const char* no_preload =
    "a build without sanitizers, which libraries can be preloaded into";
