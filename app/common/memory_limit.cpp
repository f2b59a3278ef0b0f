#include "app/common/memory_limit.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace etalon {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Returns the factor of a unit such as G, GB or GiB; 0 for an unknown one.
double unit(std::string_view text) {
    static constexpr std::string_view letters = "KMGT";
    if (text.empty() || text == "B") return 1;
    const std::size_t power = letters.find(text.front());
    const std::string_view rest = text.substr(1);
    if (power == std::string_view::npos || (rest != "" && rest != "B" && rest != "iB")) return 0;
    return std::pow(rest == "iB" ? 1024.0 : 1000.0, static_cast<double>(power + 1));
}

double machine_bytes(bool with_swap) {
    struct sysinfo info = {};
    if (sysinfo(&info) != 0) return unlimited;
    return (static_cast<double>(info.totalram) +
            (with_swap ? static_cast<double>(info.totalswap) : 0.0)) *
           info.mem_unit;
}

double number_in(const std::filesystem::path& file) {
    std::ifstream stream(file);
    double number = 0;
    return stream >> number ? number : unlimited;  // "max" is not a number
}

/// Returns the least limit of a group and of those that contain it.
double least_limit(const std::filesystem::path& root, std::filesystem::path group,
                   const char* name) {
    double least = number_in(root / name);
    for (group = group.relative_path(); !group.empty(); group = group.parent_path()) {
        least = std::min(least, number_in(root / group / name));
    }
    return least;
}

/// Returns the memory of the control group of the process, of version 2 or 1. In a container the
/// group that it sees may have another name than the system gives it.
double group_bytes() {
    const std::filesystem::path root = "/sys/fs/cgroup";
    double least = number_in(root / "memory.max");
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        const std::string group = line.substr(line.rfind(':') + 1);
        if (line.starts_with("0::")) {
            least = std::min(least, least_limit(root, group, "memory.max"));
        } else if (line.find(":memory:") != std::string::npos) {
            least = std::min(least, least_limit(root / "memory", group, "memory.limit_in_bytes"));
        }
    }
    return least;
}

/// Returns the bytes that already count for RLIMIT_DATA. Under a sanitizer these are terabytes of
/// addresses.
double bytes_in_use() {
    std::ifstream status("/proc/self/status");
    double kibibytes = 0;
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmData:")) kibibytes = std::strtod(line.c_str() + 7, nullptr);
    }
    return 1024 * kibibytes;
}

double limit_of(int resource) {
    rlimit limit = {};
    const bool is_limited = getrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0 &&
                            limit.rlim_cur != RLIM_INFINITY;
    return is_limited ? static_cast<double>(limit.rlim_cur) : unlimited;
}

}  // namespace

std::optional<double> parse_bytes(std::string_view text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    std::string_view name(rest, static_cast<std::size_t>(end - rest));
    if (name.starts_with(' ')) name.remove_prefix(1);
    const double bytes = number * unit(name);
    if (error != std::errc() || !std::isfinite(bytes) || !(bytes > 0)) return std::nullopt;
    return bytes;
}

std::string bytes_text(double bytes) {
    return bytes < 1e9 ? fmt::format("{:.1f} MB", 1e-6 * bytes)
                       : fmt::format("{:.1f} GB", 1e-9 * bytes);
}

void limit_memory(double bytes) {
    constexpr double usual_part = 0.75;
    if (bytes == 0) bytes = usual_part * std::min(machine_bytes(false), group_bytes());
    rlimit limit = {};
    const double sum = bytes + bytes_in_use();
    if (sum >= 0x1p62 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min(limit.rlim_cur, static_cast<rlim_t>(sum));
    setrlimit(RLIMIT_DATA, &limit);
}

double memory_limit() {
    return std::min(
        {machine_bytes(true), group_bytes(), limit_of(RLIMIT_AS), limit_of(RLIMIT_DATA)});
}

}  // namespace etalon
