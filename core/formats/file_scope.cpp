#include "core/formats/file_scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/formats/diagnostic_log.h"

namespace etalon {

FileScope::FileScope(const std::string& root) : root_(root) {
    std::error_code not_found;
    if (!root.empty()) real_root_ = std::filesystem::canonical(root, not_found);
}

std::string FileScope::check(const std::filesystem::path& file) const {
    if (root_.empty() || holds(file)) return {};
    return fmt::format("{} lies outside of {}, where alone files may be opened",
                       path_in_quotes(file.native()), path_in_quotes(root_));
}

/// Compares components: /scenes-2 does not lie in /scenes.
bool FileScope::holds(const std::filesystem::path& file) const {
    std::error_code error;
    const std::filesystem::path real =
        std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
    if (error || real.empty() || real_root_.empty()) return false;
    const auto [root_rest, rest] =
        std::mismatch(real_root_.begin(), real_root_.end(), real.begin(), real.end());
    return root_rest == real_root_.end() && rest != real.end();
}

}  // namespace etalon
