#include "core/formats/pbrt/normalize.h"

#include <algorithm>

#include "core/formats/pbrt/parse.h"
#include "core/formats/pbrt/write_frames.h"

namespace etalon::pbrt {
namespace {

/// Returns all frames, or the requested one; the last if there are fewer.
std::span<const Frame> wanted_frames(const std::vector<Frame>& frames, int wanted) {
    if (wanted == 0) return frames;
    const std::size_t number = std::min(static_cast<std::size_t>(wanted), frames.size());
    return std::span(frames).subspan(number - 1, 1);
}

}  // namespace

NormalizedFile normalize(std::string_view text, const std::string& path,
                         const std::filesystem::path& directory, const LoadOptions& options) {
    ParsedFile file = parse(text, path, {options.strict, options.root, options.one_sided});
    const bool is_refused = options.strict && std::ranges::count(file.diagnostics, Severity::error,
                                                                 &Diagnostic::severity) > 0;
    NormalizedFile result{std::nullopt, std::move(file.diagnostics)};
    if (file.frames.empty() || file.is_fatal || is_refused) return result;
    result.frames = static_cast<int>(file.frames.size());
    std::string& written = result.text.emplace();
    write_frames(wanted_frames(file.frames, options.frame), directory,
                 [&](std::string_view piece) { written += piece; });
    return result;
}

}  // namespace etalon::pbrt
