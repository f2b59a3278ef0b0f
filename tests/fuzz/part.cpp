#include "app/merge/merged_films.h"
#include "core/base/hash64.h"
#include "tests/fuzz/target.h"
#include "tests/temporary_folder.h"

namespace etalon::fuzz {
namespace {

/// Returns a film file with these sums and a valid hash.
std::string part_of(std::string_view sums) {
    std::string content = "etalon-film 2\n";
    content += sums;
    const std::uint64_t ending[] = {hash64(content), content.size()};
    content.append(reinterpret_cast<const char*>(ending), sizeof ending);
    return content + "EtalFilm";
}

void run(std::string_view bytes) {
    test::put("a.exr", part_of(bytes));
    test::put("b.exr", bytes);
    for (const auto& paths : {std::vector<std::string>{"a.exr"}, {"a.exr", "a.exr"}, {"b.exr"}}) {
        const Result<MergedFilms> merged = merge_films(paths);
        require(merged || !merged.error.empty(), "neither films nor an error");
    }
}

}  // namespace

const Target target = {run, true, false};

}  // namespace etalon::fuzz
