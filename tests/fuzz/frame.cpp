// libFuzzer's entry points, the same for all targets.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <span>

#include "core/base/hash64.h"
#include "tests/fuzz/limited_memory.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/text_mutator.h"
#include "tests/temporary_folder.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace etalon::fuzz {
namespace {

/// Returns the words of libFuzzer's dictionary.
std::vector<std::string>& words() {
    static std::vector<std::string> list;
    return list;
}

/// Reads lines of the form "word".
void read_words(const std::string& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.size() > 2 && line.front() == '"')
            words().push_back(line.substr(1, line.size() - 2));
    }
}

/// Makes the paths among the arguments absolute, since the process changes its working directory.
void fix_paths(std::span<char*> arguments) {
    static std::vector<std::string> kept;
    kept.reserve(arguments.size());
    for (char*& argument : arguments) {
        if (!std::filesystem::exists(argument)) continue;
        argument = kept.emplace_back(std::filesystem::absolute(argument)).data();
    }
}

/// Changes to an empty temporary directory, removed at exit, so that relative paths in an input
/// find no other files.
void enter_folder() {
    static const auto folder = std::make_unique<test::TemporaryFolder>();
    std::filesystem::current_path(*folder / "");
}

std::size_t mutate_text_in(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string changed = mutated_text(text, words(), seed).substr(0, most);
    std::copy(changed.begin(), changed.end(), data);
    return changed.size();
}

/// Runs an input with limited memory. std::bad_alloc is allowed: the programs report it as an
/// error.
void run_limited(std::string_view input, std::uint32_t failing_call) {
    try {
        const LimitedMemory memory(failing_call);
        target.run(input);
    } catch (const std::bad_alloc&) {
        return;
    }
}

/// True while an allocation is made to fail: then results are not checked.
bool is_short_of_memory = false;

/// Reads every eighth input once more with one failing allocation. Nothing may leak, which
/// libFuzzer checks.
void run_short_of_memory(std::string_view input) {
    const std::uint64_t hash = hash64(input);
    if (!target.survives_lack_of_memory || hash % 8 != 0) return;
    const std::uint32_t magnitude = hash >> 3 & 15, number = hash >> 32 & ((1U << magnitude) - 1);
    is_short_of_memory = true;
    run_limited(input, number + 1);
    is_short_of_memory = false;
}

}  // namespace

void require(bool holds, std::string_view text) {
    if (holds || is_short_of_memory) return;
    std::fprintf(stderr, "fuzz: %.*s\n", static_cast<int>(text.size()), text.data());
    std::abort();
}

}  // namespace etalon::fuzz

using namespace etalon::fuzz;

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    constexpr std::string_view option = "-dict=";
    for (int i = 1; i < *argc; ++i) {
        const std::string_view argument = (*argv)[i];
        if (argument.starts_with(option)) read_words(std::string(argument.substr(option.size())));
    }
    fix_paths({*argv + 1, static_cast<std::size_t>(*argc - 1)});
    enter_folder();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    run_limited(input, 0);
    run_short_of_memory(input);
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    if (target.is_text && seed % 2 == 0) return mutate_text_in(data, size, most, seed / 2);
    return LLVMFuzzerMutate(data, size, most);
}
