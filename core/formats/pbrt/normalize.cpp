#include "core/formats/pbrt/normalize.h"

#include <algorithm>

#include "core/formats/pbrt/parse.h"
#include "core/formats/pbrt/write_frames.h"

namespace etalon::pbrt {

NormalizedFile normalize(std::string_view text, const std::string& path,
                         const std::filesystem::path& directory, bool strict) {
    ParsedFile file = parse(text, path, {strict});
    const bool is_refused =
        strict && std::ranges::count(file.diagnostics, Severity::error, &Diagnostic::severity) > 0;
    NormalizedFile result{std::nullopt, std::move(file.diagnostics)};
    if (file.frames.empty() || file.is_fatal || is_refused) return result;
    std::string& written = result.text.emplace();
    write_frames(file.frames, directory, [&](std::string_view piece) { written += piece; });
    return result;
}

}  // namespace etalon::pbrt
