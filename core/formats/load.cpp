#include "core/formats/load.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <vector>

#include "core/formats/detect_format.h"
#include "core/formats/diagnostic_log.h"
#include "core/formats/mapped_file.h"
#include "core/formats/nearest_name.h"
#include "core/formats/nff/nff.h"
#include "core/formats/p3f/p3f.h"
#include "core/formats/pbrt/load_pbrt.h"
#include "core/formats/prt/prt.h"
#include "core/formats/sce/sce.h"

namespace etalon {
namespace {

using Loader = LoadResult (*)(std::string_view text, const std::string& path,
                              const LoadOptions& options);

struct Format {
    std::string_view name;       ///< value of --format; the extension is the same
    std::string_view described;  ///< name in messages: "this looks like ..."
    FormatMatcher matches;
    Loader load;  ///< null: only detected, so that a message can name it
    bool has_legacy = false;
};

// CONTRIBUTING.md lists the steps to add a format. Of the lines that detect a text, the first
// wins, unless the extension names another: formats with clear signs come before those with which
// others could be confused.
constexpr std::array formats = {
    Format{"sce", "an SCE scene", is_sce, load_sce, true},
    Format{"pbrt-v4", "a PBRT scene of version 4", is_pbrt_v4, nullptr},
    Format{"pbrt", "a PBRT scene", is_pbrt, load_pbrt},
    Format{"p3f", "a P3F scene", is_p3f, load_p3f, true},
    Format{"prt", "a PRT scene", is_prt, load_prt, true},
    Format{"nff", "an NFF scene", is_nff, load_nff},
    Format{"obj", "a Wavefront OBJ mesh", is_obj, nullptr},
    Format{"binary", "a binary file", is_binary, nullptr},
};

template <class Test>
std::vector<std::string_view> names_where(Test test) {
    std::vector<std::string_view> list;
    for (const Format& f : formats) {
        if (test(f)) list.push_back(f.name);
    }
    return list;
}

const std::vector<std::string_view>& names() {
    static const auto list = names_where([](const Format& f) { return f.load != nullptr; });
    return list;
}

const Format* find(std::string_view name) {
    const auto f = std::ranges::find(formats, name, &Format::name);
    return f != formats.end() ? &*f : nullptr;
}

/// Finds the format by the text, and by the extension of the path where the text shows several
/// formats or none; null if neither tells.
const Format* detect_format(std::string_view text, const std::string& path) {
    const FormatProbe probe(text);
    const std::string extension = std::filesystem::path(path).extension().string();
    const Format* const named =
        extension.empty() ? nullptr : find(std::string_view(extension).substr(1));
    if (named && named->matches(probe)) return named;
    const auto shown =
        std::ranges::find_if(formats, [&](const Format& f) { return f.matches(probe); });
    return shown != formats.end() ? &*shown : named;
}

template <class... T>
LoadResult refuse(const std::string& file, std::string_view kind, fmt::format_string<T...> text,
                  T&&... arguments) {
    DiagnosticLog log(file, {}, false);
    log.error(DiagnosticLog::whole_file, kind, text, std::forward<T>(arguments)...);
    return {std::nullopt, {}, log.take()};
}

/// Loads with a format's loader, then releases the spare capacity of the geometry.
LoadResult load_with(const Format& format, std::string_view text, const std::string& path,
                     const LoadOptions& options) {
    LoadResult result = format.load(text, path, options);
    if (!result.scene) return result;
    result.scene->format = format.name;
    shrink_to_fit(result.scene->geometry);
    return result;
}

std::string readable_names() {
    return fmt::format("Etalon reads: {}", fmt::join(names(), ", "));
}

}  // namespace

std::span<const std::string_view> format_names() {
    return names();
}

std::span<const std::string_view> legacy_names() {
    static const auto list = names_where([](const Format& f) { return f.has_legacy; });
    return list;
}

std::string_view format_of(std::string_view text, const std::string& path,
                           const LoadOptions& options) {
    const Format* const format =
        options.format.empty() ? detect_format(text, path) : find(options.format);
    return format && format->load ? format->name : std::string_view();
}

LoadResult load_scene_text(std::string_view text, const std::string& path,
                           const LoadOptions& options) {
    if (text.empty()) return refuse(path, "file", "the file is empty");
    if (text.size() > largest_file) return refuse(path, "file", "is larger than 16 GiB");
    if (!options.format.empty()) {
        const Format* const asked = find(options.format);
        if (asked && asked->load) return load_with(*asked, text, path, options);
        return refuse(path, "format", "unknown format {}; {}{}", in_quotes(options.format),
                      readable_names(), did_you_mean(options.format, names()));
    }
    const Format* const format = detect_format(text, path);
    if (!format) return refuse(path, "format", "no format recognised; {}", readable_names());
    if (format->load) return load_with(*format, text, path, options);
    return refuse(path, "format", "this looks like {}; {}", format->described, readable_names());
}

LoadResult load_scene(const std::string& path, const LoadOptions& options) {
    try {
        const MappedFile file(path);
        if (!file.error().empty()) return refuse(path, "file", "{}", file.error());
        return load_scene_text(file.text(), path, options);
    } catch (const std::bad_alloc&) {
        return refuse(path, "file", "does not fit into memory");
    }
}

}  // namespace etalon
