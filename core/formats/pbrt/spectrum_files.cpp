#include "core/formats/pbrt/spectrum_files.h"

#include "core/formats/spectrum/read_spectrum.h"

namespace etalon::pbrt {

Color SpectrumFiles::color(const std::string& name, FileLoc where) {
    const std::optional<std::string> path = tokens_.resolve(name, where);
    if (!path) return Color(0.0F);
    if (const auto known = colors_.find(*path); known != colors_.end()) return known->second;
    return colors_[*path] = read(*path, where);
}

Color SpectrumFiles::read(const std::string& path, FileLoc where) {
    const FileText file = read_file(path, FileKind::regular);
    if (!file.error.empty()) {
        log_.warn(where, "file", "the spectrum {} {}; it is black", path_in_quotes(path),
                  file.error);
        return Color(0.0F);
    }
    DiagnosticLog problems(path, file.text(), log_.is_strict());
    const std::vector<SpectralSample> samples = read_spectrum(file.text(), problems);
    log_.append(problems.list());
    return spectrum_color(samples);
}

}  // namespace etalon::pbrt
