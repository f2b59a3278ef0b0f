#include "app/trace/ray_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "core/formats/byte_order_mark.h"
#include "core/formats/file_text.h"

namespace etalon {
namespace {

struct Number {
    double value;
    int column;  ///< column of its first character, from 1
};

/// Error in a line, and its column; column 0 if there is none.
struct Fault {
    int column = 0;
    std::string_view what{};
};

struct Line {
    std::vector<Number> numbers;
    bool is_shadow = false;
};

/// Parses a line up to the first word that is wrong.
Fault parse(const std::string& line, Line& parsed) {
    constexpr const char* blanks = " \t\r";
    const std::string text = line.substr(0, line.find('#'));
    const char* at = text.c_str();
    const char* const last = at + text.size();  // beyond a NUL within the line
    while (true) {
        at += std::strspn(at, blanks);
        if (at == last) return {};
        const int column = static_cast<int>(at - text.c_str()) + 1;
        if (parsed.is_shadow) return {column, "something after 'shadow'"};
        if (std::string_view(at, std::strcspn(at, blanks)) == "shadow") {
            parsed.is_shadow = true;
            at += std::strlen("shadow");
            continue;
        }
        char* end = nullptr;
        parsed.numbers.push_back(
            {std::strtod(at, &end), column});  // decimal and hexadecimal floats
        const bool is_over = end == last || (*end != 0 && std::strchr(blanks, *end) != nullptr);
        if (end == at || !is_over) {
            return {column, "not a number"};
        }
        at = end;
    }
}

/// Returns what no ray has: an origin or a direction that is not finite, a direction of length 0,
/// or an end that is NaN.
Fault find_fault(const std::vector<Number>& n) {
    for (std::size_t i = 0; i < std::min<std::size_t>(n.size(), 8); ++i) {
        if (i < 6 && !std::isfinite(n[i].value)) return {n[i].column, "not a finite number"};
        if (std::isnan(n[i].value)) return {n[i].column, "not a number"};
    }
    const bool has_direction = n[3].value != 0 || n[4].value != 0 || n[5].value != 0;
    return has_direction ? Fault{} : Fault{n[3].column, "a direction of length 0"};
}

/// Makes a ray from a line that has numbers.
Fault make_ray(const Line& line, Ray& ray) {
    const std::vector<Number>& n = line.numbers;
    if (n.size() != 6 && n.size() != 8 && n.size() != 9) {
        return {n.empty() ? 1 : n.front().column, "wrong count of numbers"};
    }
    if (const Fault fault = find_fault(n); fault.column != 0) return fault;
    const auto vec = [&](std::size_t i) {
        return Vec3(n[i].value, n[i + 1].value, n[i + 2].value);
    };
    ray = Ray{vec(0), vec(3)};
    if (line.is_shadow) ray.set_shadow();
    if (n.size() >= 8) ray.tmin = n[6].value, ray.tmax = n[7].value;
    if (n.size() < 9) return {};
    if (!(n[8].value >= 0 && n[8].value < 1)) return {n[8].column, "time outside of [0, 1)"};
    ray.set_time(shutter_time(n[8].value));
    return {};
}

}  // namespace

Result<std::vector<Ray>> read_rays(const std::string& path) {
    const FileText file = read_file(path);
    if (!file.error.empty()) return {{}, fmt::format("{}: error: {}", path, file.error)};
    const std::string_view text = file.text();
    std::istringstream in{std::string(text.substr(byte_order_mark_size(text)))};
    std::vector<Ray> rays;
    Line parsed;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        parsed.numbers.clear();
        parsed.is_shadow = false;
        Fault fault = parse(line, parsed);
        if (parsed.numbers.empty() && !parsed.is_shadow) continue;
        Ray ray{Vec3(0), Vec3(0)};
        if (fault.column == 0) fault = make_ray(parsed, ray);
        if (fault.column != 0) {
            return {{},
                    fmt::format("{}:{}:{}: error: {}; expected '{}'", path, number, fault.column,
                                fault.what, ray_format)};
        }
        rays.push_back(ray);
    }
    return {std::move(rays), {}};
}

}  // namespace etalon
